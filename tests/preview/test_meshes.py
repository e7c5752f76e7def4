"""Meshes of a URDF on a document's links: matched by joints, served under the token, drawn."""

import struct

import pytest
from tests.preview.browser import eventually, opened, until, until_shown
from tests.preview.page import Page
from tests.preview.robots import ARM
from tornado.httpclient import AsyncHTTPClient

from kindsl.frontends.preview.document_preview import DocumentPreview
from kindsl.frontends.preview.export import exported_page
from kindsl.frontends.preview.meshes import MeshSource, mesh_data
from kindsl.frontends.preview.requests import ShowMeshes, parse_request
from kindsl.judgement.analysis.analysis import analyse
from kindsl.judgement.analysis.settings import Settings
from kindsl.robots.comparison.twins import TwinFile
from kindsl.robots.interchange.format import ORDINARY
from kindsl.robots.interchange.registry import format_named

COLLADA = """<COLLADA version="1.4.1"><asset><unit meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_images><image id="i"><init_from>http://127.0.0.1:1/x.png</init_from></image></library_images>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 10 0 0 0 0 30</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""
STL = b"\0" * 80 + struct.pack("<I12fH", 1, 0, 0, 1, 0, 0, 0, 0.1, 0, 0, 0, 0.2, 0, 0)
OBJ = "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n"
# By files of meshes: how far what is drawn reaches along x, y and z of its link.
REACHES = """() => {
  const reaches = {};
  for (const mesh of kindsl.scene.meshes.drawn) {
    mesh.geometry.computeBoundingBox();
    const { max } = mesh.geometry.boundingBox;
    (reaches[mesh.userData.link] ??= []).push([max.x, max.y, max.z].map((v) => v.toFixed(3)));
  }
  return reaches;
}"""


def bare_urdf():
    return format_named("urdf").write("arm", analyse(ARM).skeleton(), ORDINARY).text


def visual(geometry):
    return f"<visual><geometry>{geometry}</geometry></visual>"


@pytest.fixture
def urdf(tmp_path):
    """Return a URDF with shapes, beside its meshes."""
    written = bare_urdf()
    (tmp_path / "x.dae").write_text(COLLADA)
    (tmp_path / "x.stl").write_bytes(STL)
    (tmp_path / "x.obj").write_text(OBJ)
    meshes = "".join(visual(f'<mesh filename="x.{s}"/>') for s in ("dae", "stl", "obj", "glb"))
    shapes = '<box size="0.1 0.1 0.2"/>', '<sphere radius="0.1"/>'
    shapes += '<cylinder radius="0.1" length="0.3"/>', '<mesh filename="../out.stl"/>'
    for link, shown in (("upper", meshes), ("slider", "".join(map(visual, shapes)))):
        written = written.replace(f'<link name="{link}">', f'<link name="{link}">{shown}')
    file = tmp_path / "arm.urdf"
    file.write_text(written)
    return file


def shown(text, settings=None):
    preview = DocumentPreview("arm.kindsl")
    preview.show(analyse(text, settings or Settings()), ())
    return preview


def messages(preview, kind):
    return [message for message in preview.channel.state if message.type == kind]


def test_shapes_stand_on_their_links_and_what_is_left_out_is_told(urdf):
    preview = shown(ARM)
    preview.draw_meshes(MeshSource("arm.urdf", urdf))
    visuals = messages(preview, "visual")
    assert sorted((v.link, v.form) for v in visuals) == [
        *(("slider", form) for form in ("box", "cylinder", "sphere")),
        *(("upper", "mesh") for _ in range(3)),
    ]
    (told,) = messages(preview, "meshes")
    assert told.problems == (
        f"1 mesh left out, not found in '{urdf.parent.name}': x.glb",
        f"1 mesh left out, outside '{urdf.parent.name}': out.stl",
    )


def test_a_link_whose_axis_is_elsewhere_gets_no_mesh(urdf):
    preview = shown(ARM)
    preview.draw_meshes(MeshSource("arm.urdf", urdf))
    assert {v.link for v in messages(preview, "visual")} == {"upper", "slider"}
    moved = ARM.replace("rotation = (-PI/2.0, 0.0, 0.0)", "rotation = (-1.5, 0.0, 0.0)")
    preview.show(analyse(moved), ())
    assert {v.link for v in messages(preview, "visual")} == {"upper"}
    (told,) = messages(preview, "meshes")
    assert told.problems[0].startswith("meshes of 'slider' left out: the axis of its joint is")
    assert told.problems[0].endswith("is 4.06° away in arm.urdf")
    urdf.write_text(urdf.read_text().replace("prismatic", "continuous"))
    turning = ARM.replace("p_joint lift", "r_joint lift").replace("(0.4, 0.0", "(0.45, 0.0")
    preview.show(analyse(turning), ())
    (told,) = messages(preview, "meshes")
    assert told.problems[0].endswith("is 50 mm away in arm.urdf")


@pytest.mark.parametrize(
    ("text", "why"), [("<robot", "not a readable URDF"), ("<robot name='x'/>", "no link")]
)
def test_a_broken_urdf_is_told(tmp_path, text, why):
    file = tmp_path / "broken.urdf"
    file.write_text(text)
    preview = shown(ARM)
    preview.draw_meshes(MeshSource("broken.urdf", file))
    (told,) = messages(preview, "meshes")
    assert told.problems[0].startswith("broken.urdf: ")
    assert why in told.problems[0]


def test_those_of_a_twin_are_offered_and_read_when_they_are_asked_for(urdf):
    preview = shown(ARM, Settings(twins=(TwinFile(str(urdf), "../arm.urdf"),)))
    (told,) = messages(preview, "meshes")
    assert (told.name, told.is_loaded, preview.mesh_files) == ("../arm.urdf", False, {})
    assert parse_request('{"type": "show-meshes"}') == ShowMeshes()
    preview.show_meshes()
    assert len(messages(preview, "visual")) == 6


async def test_files_are_served_under_the_token_by_their_names_only(server, urdf):
    await server.show("robot", analyse(ARM), ())
    server.at("robot").draw_meshes(MeshSource("arm.urdf", urdf))
    preview = server.document(None)
    await eventually(lambda: preview.mesh_files)
    base, query = server.url("robot").split("?")
    client = AsyncHTTPClient()
    name = next(name for name in preview.mesh_files if name.endswith(".stl"))

    async def fetched(path, asked=query):
        answer = await client.fetch(f"{base}mesh/{path}?{asked}", raise_error=False)
        return answer.code, answer.body

    assert await fetched(name) == (200, STL)
    for path, asked in ((name, "token=no"), ("x.stl", query), ("..%2Fx.stl", query)):
        code, body = await fetched(path, asked)
        assert code in (403, 404)
        assert STL not in body
    (urdf.parent / "x.stl").unlink()
    assert (await fetched(name))[0] == 404


async def test_the_page_draws_them_plain_and_as_x_rays(browser, server, urdf):
    await server.show("robot", analyse(ARM), ())
    server.at("robot").draw_meshes(MeshSource("arm.urdf", urdf))
    async with opened(browser, server.url("robot")) as page:
        await until_shown(page, "Arm")
        await until(page, "kindsl.scene.meshes.drawn.length === 6")
        reaches = await page.evaluate(REACHES)
        assert sorted(reaches["upper"]) == [
            ["0.100", "0.000", "0.300"], ["0.100", "0.100", "0.000"], ["0.100", "0.200", "0.000"],
        ]  # fmt: skip
        assert await page.locator("#mesh-problems li").count() == 2
        pieces = "kindsl.scene.bodies.shown().length"
        covered = await page.evaluate(pieces)
        await page.locator("#meshes").click()
        assert await page.locator("#meshes").inner_text() == "Hide meshes"
        assert await page.evaluate(pieces) > covered
        await page.locator("#meshes").click()
        assert await page.locator("#mesh-problems").is_hidden()
        assert await page.evaluate("kindsl.address.text()") == "#"


async def test_without_a_mesh_there_is_none_to_choose(browser, server, tmp_path):
    file, lost = tmp_path / "arm.urdf", visual('<mesh filename="x.stl"/>')
    file.write_text(bare_urdf().replace('<link name="upper">', f'<link name="upper">{lost}'))
    await server.show("robot", analyse(ARM), ())
    server.at("robot").draw_meshes(MeshSource("arm.urdf", file))
    async with opened(browser, server.url("robot")) as page:
        await page.locator("#mesh-problems li").wait_for()
        assert await page.locator("#meshes").is_disabled()


async def test_an_exported_page_holds_them(browser, tmp_path, urdf):
    preview = shown(ARM)
    preview.draw_meshes(MeshSource("arm.urdf", urdf))
    page_file = tmp_path / "page.html"
    state = preview.channel.state
    page_file.write_text(exported_page([*state, *mesh_data(preview.mesh_files)]))
    assert Page(state).at("/kindsl/meshes")["meshes"]["is_loaded"]
    async with opened(browser, page_file.as_uri()) as page:
        await until_shown(page, "Arm")
        await until(page, "kindsl.scene.meshes.drawn.length === 6")
