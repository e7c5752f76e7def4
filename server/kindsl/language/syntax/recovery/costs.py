"""The costs of repairs, tuned by hand. `tests/syntax/test_costs.py` has the slip that each is for.

Inserting or leaving out a token costs 1.0 unless a row says otherwise. A name says where its amount
is added to another cost, or is a factor of it.
"""

COSTS = {
    "go back by a token": 0.12,
    "insert a value": 1.1,
    "insert a word": 1.2,
    "insert on, factor": 0.6,
    "insert a present section, more": 0.5,
    "insert '(' in a value, more": 1.0,
    "close at the end": 0.3,
    "delete an odd character": 0.5,
    "delete '='": 1.8,
    "delete on": 0.35,
    "delete what is doubled, more": -0.3,
    "delete the only section, more": 0.8,
    "replace": 1.25,
    "replace an odd character": 0.8,
    "replace '=' by a value": 1.9,
    "replace by no value, more": 0.1,
    "replace by a present section, more": 0.5,
    "replace by a lacking section, more": -0.4,
    "replace by a near word, more": -0.6,
    "read further, slack": 0.65,
    "read to the end, slack": 1.4,
    "believe a keyword": 1.5,
    "believe a section": 2.0,
    "believe frames": 1.0,
}
