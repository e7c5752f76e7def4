"""Generated from grammar/kindsl.lark by `make tables`; do not edit."""

# ruff: noqa
# fmt: off
from enum import StrEnum


class ValueKind(StrEnum):
    """The class of a value, which is the class of the parameters in it."""

    DYNAMICS = 'dynamics'
    LENGTH = 'length'
    ANGLE = 'angle'


KEYWORDS: dict[str, str] = {
    'floating': 'FLOATING', 'p_joint': 'JOINT_KIND', 'r_joint': 'JOINT_KIND',
    'inertia_params': 'INERTIA', 'inertia_properties': 'INERTIA', 'Ix': 'MOMENT', 'Ixy': 'MOMENT',
    'Ixz': 'MOMENT', 'Iy': 'MOMENT', 'Iyz': 'MOMENT', 'Iz': 'MOMENT', 'PI': 'PI', 'Pi': 'LOWER_PI',
    'pI': 'LOWER_PI', 'pi': 'LOWER_PI', 'Robot': 'Robot', 'RobotBase': 'RobotBase', 'link': 'link',
    'id': 'id', 'mass': 'mass', 'CoM': 'CoM', 'ref_frame': 'ref_frame', 'children': 'children',
    'via': 'via', 'frames': 'frames', 'translation': 'translation', 'rotation': 'rotation',
}

PUNCTUATION: str = '()*+,-/<=>[]{}'

PATTERNS: dict[str, str] = {
    'PIPE_PI': '[pP]\\||\\|[iI|]', 'PI_PREFIXED': '[pP][iI][A-Za-z_0-9]+(?!\\w)',
    'NAME': '(?![pP][iI])[A-Za-z_][A-Za-z_0-9]*(?!\\w)',
    'ESCAPED_NAME': '\\^[A-Za-z_][A-Za-z_0-9]*', 'UNICODE_NAME': '[^\\W\\d]\\w*',
    'KEYWORD_NAME': '(?!).', 'POWER_FLOAT': '[-+]?[0-9]*\\.[0-9]+[eE][0-9]+(?![\\w.])',
    'SCIENTIFIC': '[-+]?(?:(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)[eE][-+]?[0-9]+|[0-9]+\\.)(?![\\w.])',
    'MALFORMED_NUMBER': '[-+]?(?:0[xX][0-9a-fA-F]+|[0-9]+_[0-9_]+(?:\\.[0-9_]*)?|[0-9]*\\.[0-9]*\\.[0-9.]*)',
    'FLOAT': '[-+]?[0-9]*\\.[0-9]+', 'INT': '[-+]?[0-9]+', 'LINE_COMMENT': '\\/\\/[^\r\n]*',
    'BLOCK_COMMENT': '\\/\\*(?:[^*]|\\*(?!\\/))*+\\*\\/', 'BLANK': '[ \t\r\n]+',
}

IGNORED: tuple[str, ...] = (
    'BLANK', 'LINE_COMMENT', 'BLOCK_COMMENT',
)

TRIVIA: str = '(?:[ \t\r\n]+|\\/\\/[^\r\n]*|\\/\\*(?:[^*]|\\*(?!\\/))*+(?:\\*\\/|\\Z))*+'

COMMENTS: str = '\\/\\/[^\r\n]*|\\/\\*(?:[^*]|\\*(?!\\/))*+(?:\\*\\/|\\Z)'

STARTS: dict[str, tuple[int, int]] = {
    'head': (0, 7), 'base': (1, 9), 'link': (2, 11), 'joint': (3, 13), 'end': (4, 15),
    'value': (5, 37),
}

SYMBOLS: tuple[tuple[str, ...], ...] = (
    (), ('Robot',), ('head',), ('RobotBase',), ('base',), ('link',), ('JOINT_KIND',), ('joint',),
    ('}',), ('end',),
    ('ESCAPED_NAME', 'FLOAT', 'INT', 'KEYWORD_NAME', '<', 'LOWER_PI', '-', 'NAME', 'PI', 'PIPE_PI', 'PI_PREFIXED', 'POWER_FLOAT', 'SCIENTIFIC', 'UNICODE_NAME'),
    ('_pi', 'decimal', 'literal', 'pi_prefixed', 'plain_name', 'stored', 'symbol', 'value'),
    ('ESCAPED_NAME', 'KEYWORD_NAME', 'LOWER_PI', 'NAME', 'PI_PREFIXED', 'UNICODE_NAME'), ('_name',),
    ('$END',), ('$END', '=', '[', '>', '/'),
    ('$END', 'ESCAPED_NAME', 'KEYWORD_NAME', 'LOWER_PI', '-', 'NAME', 'PI', 'PIPE_PI', 'PI_PREFIXED', '/', '*', 'UNICODE_NAME'),
    ('_pi', 'pi_prefixed', 'plain_name', 'symbol'), ('$END', '>', ']', '*'),
    ('any_name', 'plain_name'),
    ('$END', 'CoM', ',', '[', 'mass', '-', 'MOMENT', '>', '+', '}', 'ref_frame', ')', ']', '/', '*'),
    ('ESCAPED_NAME', 'FLOAT', 'KEYWORD_NAME', '<', 'LOWER_PI', 'NAME', 'PI', 'PIPE_PI', 'PI_PREFIXED', 'POWER_FLOAT', 'SCIENTIFIC', 'UNICODE_NAME'),
    ('_pi', 'decimal', 'pi_prefixed', 'plain_name', 'stored', 'symbol'), ('$END', '/'),
    ('$END', '/', '*'), ('/', '*'), ('*',), ('$END', '[', '/'),
    ('CoM', '=', 'ESCAPED_NAME', 'FLOATING', 'KEYWORD_NAME', '{', 'LOWER_PI', 'mass', 'MOMENT', '>', 'NAME', 'PI_PREFIXED', '}', 'ref_frame', 'UNICODE_NAME', 'via'),
    ('{',), ('FLOATING', '{'),
    ('ESCAPED_NAME', 'KEYWORD_NAME', 'LOWER_PI', 'NAME', 'PI', 'PIPE_PI', 'PI_PREFIXED', 'UNICODE_NAME'),
    ('=', '>'), ('/',), ('FLOAT', 'INT', 'POWER_FLOAT', 'SCIENTIFIC'), ('decimal', 'literal'),
    ('_pi', 'decimal', 'operand', 'pi_prefixed', 'plain_name', 'stored', 'symbol'), ('inexact',),
    ('children', 'frames', 'id', 'INERTIA', '}'),
    ('__base_star_1', '_section', 'children', 'frames', 'id', 'inertia'), ('id', '}', 'ref_frame'),
    ('__joint_star_2', '_joint_section', 'id', 'joint_frame'), ('$END', '>', ']'), (']',),
    ('__frames_plus_5', 'frame_group'), ('=',), ('_section', 'children', 'frames', 'id', 'inertia'),
    ('_joint_section', 'id', 'joint_frame'), ('>',),
    ('ESCAPED_NAME', 'KEYWORD_NAME', 'LOWER_PI', 'NAME', 'PI_PREFIXED', '}', 'UNICODE_NAME'),
    ('__children_star_4', '_name', 'child'), ('__frame_group_star_6', '_name', 'frame'),
    ('children', 'frames', 'id', 'INERTIA', '{', '}'), ('frame_group',), ('INT',),
    ('CoM', 'mass', 'MOMENT', '}', 'ref_frame'),
    ('__inertia_star_3', '_inertia_section', 'com', 'inertia_frame', 'mass', 'moment'),
    ('}', 'rotation', 'translation'),
    ('__frame_star_7', '_pose_section', 'rotation', 'translation'), ('_name', 'child'), ('via',),
    ('_name', 'frame'), ('children', 'frames', 'id', 'INERTIA', '}', 'ref_frame'),
    ('_inertia_section', 'com', 'inertia_frame', 'mass', 'moment'),
    ('_pose_section', 'rotation', 'translation'), ('(',), ('vector',),
    ('ESCAPED_NAME', 'FLOAT', 'INT', 'KEYWORD_NAME', '<', 'LOWER_PI', '(', 'MALFORMED_NUMBER', '-', 'NAME', 'PI', 'PIPE_PI', 'PI_PREFIXED', '+', 'POWER_FLOAT', 'SCIENTIFIC', 'UNICODE_NAME'),
    ('_expression', '_number', '_parameter', '_pi', 'atom', 'product', 'signed', 'sum'),
    ('CoM', ',', '[', 'mass', '-', 'MOMENT', '>', '+', '}', 'ref_frame', ')', ']', '/', '*'),
    ('CoM', ',', 'ESCAPED_NAME', 'KEYWORD_NAME', 'LOWER_PI', 'mass', '-', 'MOMENT', '>', 'NAME', 'PI', 'PIPE_PI', 'PI_PREFIXED', '+', '}', 'ref_frame', ')', ']', '/', '*', 'UNICODE_NAME'),
    ('_number', '_parameter', '_pi', 'atom', 'signed'), ('_parameter', '_pi'),
    ('CoM', ',', 'mass', '-', 'MOMENT', '>', '+', '}', 'ref_frame', ')', ']', '/', '*'),
    ('CoM', ',', 'mass', '-', 'MOMENT', '>', '+', '}', 'ref_frame', ')', ']'), (',',), (')',),
    ('_number', '_parameter', '_pi', 'atom', 'product', 'signed'),
    ('CoM', 'mass', 'MOMENT', '}', 'ref_frame', 'rotation', 'translation'),
)

STATES: tuple[tuple[str, int, int | tuple[int, ...], int, tuple[int, ...]], ...] = (
    ('', 1, 6, 2, (7,)), ('', 3, 8, 4, (9,)), ('', 5, 10, 5, (11,)), ('', 6, 12, 7, (13,)),
    ('', 8, 14, 9, (15,)),
    ('', 10, (16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29), 11, (30, 31, 32, 33, 34, 35, 36, 37)),
    ('head', 12, (38, 39, 40, 41, 42, 43), 13, (44,)), ('', 0, (), 0, ()),
    ('base', 12, (38, 39, 40, 41, 42, 43), 13, (45,)), ('', 0, (), 0, ()),
    ('link', 12, (38, 39, 40, 41, 42, 43), 13, (46,)), ('', 0, (), 0, ()),
    ('joint', 12, (38, 39, 40, 41, 42, 43), 13, (47,)), ('', 0, (), 0, ()), ('end', 14, -1, 0, ()),
    ('', 0, (), 0, ()), ('plain_name', 15, -2, 0, ()),
    ('', 16, (-3, 16, 19, 21, 48, 23, 24, 25, 26, -4, -4, 29), 17, (30, 33, 49, 50)),
    ('literal', 18, -5, 0, ()), ('plain_name', 15, -6, 0, ()),
    ('stored', 12, (16, 19, 51, 23, 52, 29), 19, (53, 54)), ('', 20, -7, 0, ()),
    ('', 21, (16, 55, 19, 20, 21, 23, 24, 25, 26, 56, 57, 29), 22, (30, 58, 33, 34, 59, 60)),
    ('plain_name', 15, -8, 0, ()), ('', 20, -9, 0, ()), ('', 20, -10, 0, ()),
    ('pi_prefixed', 23, -11, 0, ()), ('', 24, (-12, -13, -13), 0, ()),
    ('', 24, (-14, -15, -15), 0, ()), ('plain_name', 15, -16, 0, ()), ('symbol', 23, -17, 0, ()),
    ('', 25, (61, -18), 0, ()), ('product_by_star', 26, 62, 0, ()), ('symbol', 23, -19, 0, ()),
    ('', 27, (-20, 63, -20), 0, ()), ('', 23, (-21, 64), 0, ()), ('', 23, (-22, 65), 0, ()),
    ('', 0, (), 0, ()), ('', 28, -23, 0, ()), ('', 28, -24, 0, ()), ('', 28, -25, 0, ()),
    ('', 28, -26, 0, ()), ('', 28, -27, 0, ()), ('', 28, -28, 0, ()), ('head', 29, 66, 0, ()),
    ('base', 30, (67, 68), 0, ()), ('link', 29, 69, 0, ()), ('joint', 29, 70, 0, ()),
    ('product_by_juxtaposition', 31, (16, 19, 21, 23, 24, 25, 26, 29), 17, (30, 33, 49, 71)),
    ('symbol', 14, -20, 0, ()), ('product_by_juxtaposition', 14, -29, 0, ()),
    ('any_name', 32, -30, 0, ()), ('any_name', 32, -31, 0, ()), ('stored', 32, (72, 73), 0, ()),
    ('any_name', 32, -32, 0, ()), ('', 23, (-33, -4), 0, ()), ('', 23, (-34, -13), 0, ()),
    ('', 23, (-35, -15), 0, ()), ('number_fraction', 33, 74, 0, ()), ('', 23, (-36, 75), 0, ()),
    ('', 23, (-37, 76), 0, ()), ('number_fraction', 34, (77, 18, 78, 79), 35, (80, 81)),
    ('product_by_star', 21, (16, 77, 19, 20, 21, 23, 24, 25, 26, 78, 79, 29), 36, (30, 82, 83, 33, 34, 84, 85)),
    ('stored', 34, (77, 18, 78, 79), 35, (80, 86)),
    ('stored_value_fraction', 34, (77, 18, 78, 79), 35, (80, 87)),
    ('', 34, (88, 89, 90, 91), 37, (92,)), ('head', 14, -38, 0, ()), ('base', 29, 93, 0, ()),
    ('base', 38, (94, 95, 96, 97, 98), 39, (99, 100, 101, 102, 103, 104)),
    ('link', 38, (94, 95, 96, 97, 105), 39, (106, 100, 101, 102, 103, 104)),
    ('joint', 40, (96, 107, 108), 41, (109, 110, 111, 112)),
    ('product_by_juxtaposition', 14, -39, 0, ()), ('stored', 34, (77, 18, 78, 79), 35, (80, 113)),
    ('stored', 23, -40, 0, ()), ('number_fraction', 34, (77, 18, 78, 79), 35, (80, 114)),
    ('stored_value_fraction', 34, (77, 18, 78, 79), 35, (80, 115)),
    ('', 34, (116, 89, 90, 91), 37, (117,)), ('decimal', 42, -4, 0, ()),
    ('decimal', 42, -13, 0, ()), ('decimal', 42, -15, 0, ()), ('literal', 42, -18, 0, ()),
    ('number_fraction', 14, -41, 0, ()), ('operand', 14, -42, 0, ()),
    ('product_by_star', 14, -43, 0, ()), ('operand', 14, -44, 0, ()), ('operand', 14, -45, 0, ()),
    ('stored', 43, 118, 0, ()), ('stored_value_fraction', 14, -46, 0, ()),
    ('symbolic_fraction', 14, -47, 0, ()), ('inexact', 14, -48, 0, ()), ('inexact', 14, -49, 0, ()),
    ('inexact', 14, -50, 0, ()), ('symbolic_fraction_loose', 14, -51, 0, ()),
    ('base', 38, (94, 95, 96, 97, 119), 39, (120, 100, 101, 102, 103, 104)),
    ('children', 29, 121, 0, ()), ('frames', 29, 122, 44, (123, 124)), ('id', 45, 125, 0, ()),
    ('inertia', 29, 126, 0, ()), ('base', 14, -52, 0, ()),
    ('base', 38, (94, 95, 96, 97, 127), 46, (128, 101, 102, 103, 104)), ('', 38, -53, 0, ()),
    ('', 38, -54, 0, ()), ('', 38, -55, 0, ()), ('', 38, -56, 0, ()), ('', 38, -57, 0, ()),
    ('link', 14, -58, 0, ()), ('link', 38, (94, 95, 96, 97, 129), 46, (128, 101, 102, 103, 104)),
    ('joint', 14, -59, 0, ()), ('joint_frame', 29, 130, 0, ()),
    ('joint', 40, (96, 131, 108), 47, (132, 111, 112)), ('', 40, -60, 0, ()), ('', 40, -61, 0, ()),
    ('', 40, -62, 0, ()), ('stored', 48, 133, 0, ()), ('number_fraction', 14, -63, 0, ()),
    ('stored_value_fraction', 14, -64, 0, ()), ('symbolic_fraction', 14, -65, 0, ()),
    ('symbolic_fraction_loose', 14, -66, 0, ()), ('stored', 23, -67, 0, ()),
    ('base', 14, -68, 0, ()), ('base', 38, (94, 95, 96, 97, 134), 46, (128, 101, 102, 103, 104)),
    ('children', 49, (38, 39, 40, 41, 42, 135, 43), 50, (136, 137, 138)),
    ('frame_group', 49, (38, 39, 40, 41, 42, 139, 43), 51, (140, 141, 142)),
    ('frames', 52, (-69, -69, -69, -69, 122, -69), 53, (143,)), ('', 52, -70, 0, ()),
    ('id', 54, 144, 0, ()),
    ('inertia', 55, (145, 146, 147, 148, 149), 56, (150, 151, 152, 153, 154, 155)),
    ('base', 14, -71, 0, ()), ('', 38, -72, 0, ()), ('link', 14, -73, 0, ()),
    ('joint_frame', 57, (156, 157, 158), 58, (159, 160, 161, 162)), ('joint', 14, -74, 0, ()),
    ('', 40, -75, 0, ()), ('stored', 23, -76, 0, ()), ('base', 14, -77, 0, ()),
    ('children', 38, -78, 0, ()), ('children', 49, (38, 39, 40, 41, 42, 163, 43), 59, (137, 164)),
    ('child', 60, 165, 0, ()), ('', 49, -79, 0, ()), ('frame_group', 52, -80, 0, ()),
    ('frame_group', 49, (38, 39, 40, 41, 42, 166, 43), 61, (141, 167)), ('frame', 29, 168, 0, ()),
    ('', 49, -81, 0, ()), ('', 52, -82, 0, ()), ('id', 62, -83, 0, ()), ('com', 45, 169, 0, ()),
    ('mass', 45, 170, 0, ()), ('moment', 45, 171, 0, ()), ('inertia', 38, -84, 0, ()),
    ('inertia_frame', 45, 172, 0, ()),
    ('inertia', 55, (145, 146, 147, 173, 149), 63, (174, 152, 153, 154, 155)), ('', 55, -85, 0, ()),
    ('', 55, -86, 0, ()), ('', 55, -87, 0, ()), ('', 55, -88, 0, ()), ('', 55, -89, 0, ()),
    ('joint_frame', 40, -90, 0, ()), ('rotation', 45, 175, 0, ()), ('translation', 45, 176, 0, ()),
    ('joint_frame', 57, (177, 157, 158), 64, (178, 161, 162)), ('', 57, -91, 0, ()),
    ('', 57, -92, 0, ()), ('', 57, -93, 0, ()), ('children', 38, -94, 0, ()), ('', 49, -95, 0, ()),
    ('child', 12, (38, 39, 40, 41, 42, 43), 13, (179,)), ('frame_group', 52, -96, 0, ()),
    ('', 49, -97, 0, ()), ('frame', 57, (180, 157, 158), 58, (181, 160, 161, 162)),
    ('com', 65, 182, 66, (183,)),
    ('mass', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (198, 199, 200, 201, 202, 203, 204, 205)),
    ('moment', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (206, 199, 200, 201, 202, 203, 204, 205)),
    ('inertia_frame', 12, (38, 39, 40, 41, 42, 43), 13, (207,)), ('inertia', 38, -98, 0, ()),
    ('', 55, -99, 0, ()), ('rotation', 65, 182, 66, (208,)), ('translation', 65, 182, 66, (209,)),
    ('joint_frame', 40, -100, 0, ()), ('', 57, -101, 0, ()), ('child', 49, -102, 0, ()),
    ('frame', 49, -103, 0, ()), ('frame', 57, (210, 157, 158), 64, (178, 161, 162)),
    ('vector', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (211, 199, 200, 201, 202, 203, 204, 205)),
    ('com', 55, -104, 0, ()), ('', 69, -105, 0, ()), ('', 70, -106, 0, ()), ('', 70, -107, 0, ()),
    ('', 69, -108, 0, ()), ('', 12, (38, 39, 40, 41, 42, 43), 13, (212,)),
    ('group', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (213, 199, 200, 201, 202, 203, 204, 205)),
    ('', 70, -109, 0, ()),
    ('negate', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 71, (199, 200, 201, 202, 214)),
    ('', 69, -110, 0, ()), ('', 69, -111, 0, ()),
    ('plus', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 71, (199, 200, 201, 202, 215)),
    ('', 70, -112, 0, ()), ('', 70, -113, 0, ()), ('', 69, -114, 0, ()), ('mass', 55, -115, 0, ()),
    ('', 70, (-116, -116, 184, 187, 21, -116, -116, -116, -116, 192, 24, 25, 193, -116, -116, -116, -116, -116, -116, -116, 197), 72, (216, 217)),
    ('', 69, (-117, -117, 218, -117, -117, -117, -117, -117, -117, -117, -117, -117, -117, -117), 0, ()),
    ('', 69, (-118, -118, 219, -118, -118, -118, -118, -118, -118, -118, -118, -118, -118, -118), 0, ()),
    ('signed', 73, -119, 0, ()),
    ('', 73, (-120, -120, -120, -120, -120, -120, -120, -120, -120, -120, -120, 220, 221), 0, ()),
    ('product', 73, -121, 0, ()),
    ('', 74, (-122, -122, -122, 222, -122, -122, 223, -122, -122, -122, -122), 0, ()),
    ('moment', 55, -123, 0, ()), ('inertia_frame', 55, -124, 0, ()), ('rotation', 57, -125, 0, ()),
    ('translation', 57, -126, 0, ()), ('frame', 49, -127, 0, ()), ('vector', 75, 224, 0, ()),
    ('', 32, (225, 226), 0, ()), ('group', 76, 227, 0, ()), ('negate', 73, -128, 0, ()),
    ('plus', 73, -129, 0, ()),
    ('juxtaposed_parameter', 69, (-130, -130, 228, -130, -130, -130, -130, -130, -130, -130, -130, -130, -130, -130), 0, ()),
    ('juxtaposed_pi', 73, -131, 0, ()),
    ('defaulted', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (229, 199, 200, 201, 202, 203, 204, 205)),
    ('defaulted', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (230, 199, 200, 201, 202, 203, 204, 205)),
    ('divide', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 71, (199, 200, 201, 202, 231)),
    ('multiply', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 71, (199, 200, 201, 202, 232)),
    ('subtract', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 77, (199, 200, 201, 202, 233, 204)),
    ('add', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 77, (199, 200, 201, 202, 234, 204)),
    ('vector', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (235, 199, 200, 201, 202, 203, 204, 205)),
    ('constant', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (236, 199, 200, 201, 202, 203, 204, 205)),
    ('constant_use', 73, -132, 0, ()), ('group', 73, -133, 0, ()),
    ('juxtaposed_parameter', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (237, 199, 200, 201, 202, 203, 204, 205)),
    ('defaulted', 43, 238, 0, ()), ('defaulted', 43, 239, 0, ()), ('divide', 73, -134, 0, ()),
    ('multiply', 73, -135, 0, ()),
    ('', 73, (-136, -136, -136, -136, -136, -136, -136, -136, -136, -136, -136, 220, 221), 0, ()),
    ('', 73, (-137, -137, -137, -137, -137, -137, -137, -137, -137, -137, -137, 220, 221), 0, ()),
    ('vector', 75, 240, 0, ()), ('constant', 48, 241, 0, ()),
    ('juxtaposed_parameter', 43, 242, 0, ()), ('defaulted', 73, -138, 0, ()),
    ('defaulted', 73, -139, 0, ()),
    ('vector', 67, (184, 185, 186, 187, 188, 21, 189, 190, 191, 192, 24, 25, 193, 194, 195, 196, 197), 68, (243, 199, 200, 201, 202, 203, 204, 205)),
    ('constant', 73, -140, 0, ()), ('juxtaposed_parameter', 73, -141, 0, ()),
    ('vector', 76, 244, 0, ()), ('vector', 78, -142, 0, ()),
)

RULES: tuple[tuple[int, str, str, str], ...] = (
    (1, 'end', 'node', 'end'), (1, 'plain_name', 'node', 'plain_name'),
    (1, 'value', 'node', 'float'), (1, 'decimal', 'node', 'decimal'),
    (1, 'literal', 'node', 'literal'), (1, 'plain_name', 'node', 'plain_name'),
    (1, '_pi', 'pass', '_pi'), (1, 'plain_name', 'node', 'plain_name'), (1, '_pi', 'pass', '_pi'),
    (1, '_pi', 'pass', '_pi'), (1, 'pi_prefixed', 'node', 'pi_prefixed'),
    (1, 'value', 'node', 'power_or_product'), (1, 'decimal', 'node', 'decimal'),
    (1, 'value', 'node', 'scientific'), (1, 'decimal', 'node', 'decimal'),
    (1, 'plain_name', 'node', 'plain_name'), (1, 'symbol', 'node', 'symbol'),
    (1, 'literal', 'node', 'literal'), (1, 'symbol', 'node', 'symbol'),
    (1, 'symbol', 'node', 'symbol'), (1, 'value', 'node', 'stored_value'),
    (1, 'value', 'node', 'symbolic'), (1, '_name', 'name', '_name'), (1, '_name', 'name', '_name'),
    (1, '_name', 'name', '_name'), (1, '_name', 'pass', '_name'), (1, '_name', 'name', '_name'),
    (1, '_name', 'name', '_name'), (2, 'value', 'node', 'product_by_juxtaposition'),
    (1, 'any_name', 'node', 'any_name'), (1, 'any_name', 'node', 'any_name'),
    (1, 'any_name', 'node', 'any_name'), (2, 'value', 'node', 'spaced_minus'),
    (2, 'value', 'node', 'spaced_minus'), (2, 'value', 'node', 'scientific'),
    (2, 'value', 'node', 'stored_value'), (2, 'value', 'node', 'symbolic'),
    (3, 'head', 'node', 'head'), (3, 'value', 'node', 'product_by_juxtaposition'),
    (3, 'stored', 'node', 'stored'), (3, 'value', 'node', 'number_fraction'),
    (1, 'operand', 'node', 'operand'), (3, 'value', 'node', 'product_by_star'),
    (1, 'operand', 'node', 'operand'), (1, 'operand', 'node', 'operand'),
    (3, 'value', 'node', 'stored_value_fraction'), (3, 'value', 'node', 'symbolic_fraction'),
    (1, 'inexact', 'node', 'inexact'), (1, 'inexact', 'node', 'inexact'),
    (1, 'inexact', 'node', 'inexact'), (3, 'value', 'node', 'symbolic_fraction_loose'),
    (4, 'base', 'node', 'base'), (1, '__base_star_1', 'list', '__base_star_1'),
    (1, '_section', 'pass', '_section'), (1, '_section', 'pass', '_section'),
    (1, '_section', 'pass', '_section'), (1, '_section', 'pass', '_section'),
    (4, 'link', 'node', 'link'), (4, 'joint', 'node', 'joint'),
    (1, '__joint_star_2', 'list', '__joint_star_2'),
    (1, '_joint_section', 'pass', '_joint_section'),
    (1, '_joint_section', 'pass', '_joint_section'), (4, 'value', 'node', 'number_fraction'),
    (4, 'value', 'node', 'stored_value_fraction'), (4, 'value', 'node', 'symbolic_fraction'),
    (4, 'value', 'node', 'symbolic_fraction_loose'), (4, 'stored', 'node', 'stored'),
    (5, 'base', 'node', 'base'), (2, 'frames', 'splice', 'frames'),
    (1, '__frames_plus_5', 'list', '__frames_plus_5'), (5, 'base', 'splice', 'base'),
    (2, '__base_star_1', 'extend', '__base_star_1'), (5, 'link', 'splice', 'link'),
    (5, 'joint', 'splice', 'joint'), (2, '__joint_star_2', 'extend', '__joint_star_2'),
    (5, 'stored', 'node', 'stored'), (6, 'base', 'splice', 'base'),
    (3, 'children', 'node', 'children'), (1, '__children_star_4', 'list', '__children_star_4'),
    (2, 'frame_group', 'node', 'frame_group'),
    (1, '__frame_group_star_6', 'list', '__frame_group_star_6'),
    (2, '__frames_plus_5', 'extend', '__frames_plus_5'), (3, 'id', 'node', 'id'),
    (3, 'inertia', 'node', 'inertia'), (1, '__inertia_star_3', 'list', '__inertia_star_3'),
    (1, '_inertia_section', 'pass', '_inertia_section'),
    (1, '_inertia_section', 'pass', '_inertia_section'),
    (1, '_inertia_section', 'pass', '_inertia_section'),
    (1, '_inertia_section', 'pass', '_inertia_section'), (3, 'joint_frame', 'node', 'joint_frame'),
    (1, '__frame_star_7', 'list', '__frame_star_7'), (1, '_pose_section', 'pass', '_pose_section'),
    (1, '_pose_section', 'pass', '_pose_section'), (4, 'children', 'splice', 'children'),
    (2, '__children_star_4', 'extend', '__children_star_4'),
    (3, 'frame_group', 'splice', 'frame_group'),
    (2, '__frame_group_star_6', 'extend', '__frame_group_star_6'),
    (4, 'inertia', 'splice', 'inertia'), (2, '__inertia_star_3', 'extend', '__inertia_star_3'),
    (4, 'joint_frame', 'splice', 'joint_frame'), (2, '__frame_star_7', 'extend', '__frame_star_7'),
    (3, 'child', 'node', 'child'), (3, 'frame', 'node', 'frame'), (3, 'com', 'node', 'com'),
    (1, '_parameter', 'name', '_parameter'), (1, '_number', 'pass', '_number'),
    (1, '_number', 'pass', '_number'), (1, '_parameter', 'name', '_parameter'),
    (1, '_number', 'pass', '_number'), (1, '_parameter', 'pass', '_parameter'),
    (1, '_parameter', 'name', '_parameter'), (1, '_number', 'pass', '_number'),
    (1, '_number', 'pass', '_number'), (1, '_parameter', 'name', '_parameter'),
    (3, 'mass', 'node', 'mass'), (1, 'atom', 'node', 'number'), (1, 'atom', 'node', 'parameter'),
    (1, 'atom', 'node', 'pi'), (1, 'signed', 'pass', 'signed'), (1, 'sum', 'pass', 'sum'),
    (1, 'product', 'pass', 'product'), (1, '_expression', 'pass', '_expression'),
    (3, 'moment', 'node', 'moment'), (3, 'inertia_frame', 'node', 'inertia_frame'),
    (3, 'rotation', 'node', 'rotation'), (3, 'translation', 'node', 'translation'),
    (4, 'frame', 'splice', 'frame'), (2, 'signed', 'node', 'negate'), (2, 'signed', 'node', 'plus'),
    (2, 'atom', 'node', 'juxtaposed_parameter'), (2, 'atom', 'node', 'juxtaposed_pi'),
    (3, 'atom', 'node', 'constant_use'), (3, 'atom', 'node', 'group'),
    (3, 'product', 'node', 'divide'), (3, 'product', 'node', 'multiply'),
    (3, 'sum', 'node', 'subtract'), (3, 'sum', 'node', 'add'), (4, 'atom', 'node', 'defaulted'),
    (4, 'atom', 'node', 'defaulted'), (5, 'atom', 'node', 'constant'),
    (5, 'atom', 'node', 'juxtaposed_parameter'), (7, 'vector', 'node', 'vector'),
)

HOLDS: dict[str, tuple[str, ...]] = {
    'document': ('head', 'base', 'link', 'joint', 'end'),
    'base': ('id', 'inertia', 'children', 'frames'),
    'link': ('id', 'inertia', 'children', 'frames'), 'joint': ('id', 'joint_frame'),
    'inertia': ('mass', 'com', 'moment', 'inertia_frame'), 'children': ('child',),
    'frames': ('frame_group',), 'joint_frame': ('translation', 'rotation'),
    'frame_group': ('frame',), 'frame': ('translation', 'rotation'),
}

WORDS: dict[str, tuple[str, ...]] = {
    'head': ('Robot',), 'base': ('RobotBase',), 'link': ('link',), 'joint': ('r_joint', 'p_joint'),
    'end': ('}',), 'id': ('id',), 'inertia': ('inertia_params', 'inertia_properties'),
    'children': ('children',), 'frames': ('frames',), 'joint_frame': ('ref_frame',),
    'mass': ('mass',), 'com': ('CoM',), 'moment': ('Ix', 'Iy', 'Iz', 'Ixy', 'Ixz', 'Iyz'),
    'inertia_frame': ('ref_frame',), 'child': (), 'frame_group': ('{',),
    'translation': ('translation',), 'rotation': ('rotation',), 'frame': (),
}

KINDS: dict[str, str] = {
    'head': 'row', 'base': 'block', 'link': 'block', 'joint': 'block', 'end': 'row', 'id': 'whole',
    'inertia': 'block', 'children': 'list', 'frames': 'groups', 'joint_frame': 'pose',
    'mass': 'scalar', 'com': 'vector', 'moment': 'moments', 'inertia_frame': 'name', 'child': 'row',
    'frame_group': 'group', 'translation': 'vector', 'rotation': 'vector', 'frame': 'pose',
}

CLASSES: dict[str, tuple[str, ...]] = {
    '_number': ('FLOAT', 'INT', 'SCIENTIFIC', 'POWER_FLOAT', 'MALFORMED_NUMBER'),
    '_pi': ('PI', 'LOWER_PI', 'PIPE_PI'),
    '_parameter': ('NAME', 'PI_PREFIXED', 'UNICODE_NAME', 'ESCAPED_NAME', 'KEYWORD_NAME'),
    '_name': ('NAME', 'PI_PREFIXED', 'UNICODE_NAME', 'ESCAPED_NAME', 'KEYWORD_NAME', 'LOWER_PI'),
}

FORMS: tuple[str, ...] = (
    'add', 'subtract', 'multiply', 'divide', 'negate', 'plus', 'number', 'pi', 'parameter',
    'defaulted', 'juxtaposed_pi', 'juxtaposed_parameter', 'constant', 'constant_use', 'group',
)

ORDERS: dict[str, tuple[str, ...]] = {
    'document': ('head', 'base', 'link+', 'joint+', 'end'),
    'base': ('inertia?', 'children', 'frames?'), 'link': ('id', 'inertia?', 'children', 'frames?'),
    'joint': ('id?', 'joint_frame'), 'inertia': ('mass', 'com', 'moment+', 'inertia_frame?'),
    'frame': ('translation', 'rotation'), 'joint_frame': ('translation', 'rotation'),
}

ONLY: dict[str, str] = {
    'product_by_juxtaposition': 'robcogen', 'spaced_minus': 'robcogen2', 'scientific': 'robcogen2',
    'number_fraction': 'robcogen2', 'product_by_star': 'robcogen2',
    'symbolic_fraction_loose': 'robcogen2', 'stored_value': 'robcogen2',
    'stored_value_fraction': 'robcogen2', 'pi_prefixed': 'robcogen', 'PIPE_PI': 'robcogen2',
    'ESCAPED_NAME': 'robcogen', 'UNICODE_NAME': 'robcogen2', 'KEYWORD_NAME': 'robcogen2',
    'SCIENTIFIC': 'robcogen2', 'BLOCK_COMMENT': 'robcogen',
}

NEITHER: dict[str, str] = {
    'MALFORMED_NUMBER': 'KD005',
}

DECLARES: dict[str, str] = {
    'head': 'robot', 'base': 'link', 'link': 'link', 'joint': 'joint', 'frame': 'frame',
}

REFERS: dict[str, tuple[str, ...]] = {
    'inertia_frame': ('frame',), 'child': ('link', 'joint'),
}

VALUES: dict[str, tuple[ValueKind, str]] = {
    'mass': (ValueKind.DYNAMICS, 'kg'), 'com': (ValueKind.DYNAMICS, 'm'),
    'moment': (ValueKind.DYNAMICS, 'kg·m²'), 'translation': (ValueKind.LENGTH, 'm'),
    'rotation': (ValueKind.ANGLE, 'rad'),
}
