namespace Engraver.Core.EntityTables;

/// <summary>The table as one JSON object: <c>{"columns":["s0",...],"rows":[[...],...]}</c>, one row per line.</summary>
public static class EntityTableJson
{
    public static void Write(EntityTable table, TextWriter output)
    {
        output.Write("{\"columns\":[");
        output.Write(string.Join(',', Enumerable.Range(0, EntitySlot.Count).Select(slot => $"\"s{slot}\"")));
        output.Write("],\"rows\":[");
        for (var row = 0; row < table.Count; row++)
        {
            output.Write(row == 0 ? "\n[" : ",\n[");
            EntityTableCsv.WriteCells(table[row], output);
            output.Write(']');
        }

        output.Write("]}\n");
    }
}
