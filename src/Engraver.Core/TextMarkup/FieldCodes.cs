namespace Engraver.Core.TextMarkup;

/// <summary>Field codes in a string: %&lt;\AcVar Date&gt;%. A DXF has the value of a field as text; where the code itself is in the string, it has no
/// value.</summary>
internal static class FieldCodes
{
    /// <summary>The index after each field code that has an end, by the index of its beginning. They nest.</summary>
    public static Dictionary<int, int> EndsIn(string raw)
    {
        var (ends, open) = (new Dictionary<int, int>(), new Stack<int>());
        if (!raw.Contains("%<\\", StringComparison.Ordinal)) return ends;
        for (var at = 0; at + 1 < raw.Length; at++)
        {
            if (raw[at] == '%' && raw[at + 1] == '<') open.Push(at);
            else if (raw[at] == '>' && raw[at + 1] == '%' && open.TryPop(out var start) && raw.AsSpan(start).StartsWith("%<\\")) ends[start] = at + 2;
        }

        return ends;
    }
}
