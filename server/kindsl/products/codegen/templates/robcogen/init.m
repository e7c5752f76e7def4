function tr = init@what@(varargin)
{% if not matrices %}
    tr = struct();
{% endif %}
{% for name, rows in matrices.items() %}
    tr.@name@ = zeros(@rows|length@, @rows[0]|length@);
{% for row in rows %}
{% set i = loop.index %}
{% for entry in row %}
{% if entry is number and entry %}
    tr.@name@(@i@, @loop.index@) = @entry@;
{% endif %}
{% endfor %}
{% endfor %}
{% endfor %}
end
