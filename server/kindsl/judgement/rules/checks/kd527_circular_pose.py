"""A pose is relative to itself.

## What it does
Reports links, joints and frames of an SDF whose poses are each given in the frame of the next one,
until the last is given in that of the first; and frames that are attached to each other so.

## Why is this bad?
Nothing says where any of them is: no program can load the model.

## Example
```xml
<frame name="flange"><pose relative_to="tool">0 0 0.1 0 0 0</pose></frame>
<frame name="tool"><pose relative_to="flange">0 0 -0.1 0 0 0</pose></frame>
```
"""

from kindsl.judgement.rules.base import Rule, Severity

RULE = Rule(__name__, Severity.ERROR)
