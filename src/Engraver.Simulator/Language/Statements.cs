using System.Text;

namespace Engraver.Simulator.Language;

/// <summary>Divides lines into statements and removes blanks without meaning (galil-dmc.md A.3).</summary>
internal static class Statements
{
    /// <summary>The parts between semicolons; a semicolon in quotes does not divide. Whether ";" ends a comment is not documented (L.3): here it
    /// does.</summary>
    public static Statement[] Split(string line)
    {
        var parts = new List<Statement>();
        var quoted = false;
        var start = 0;
        for (var i = 0; i <= line.Length; i++)
        {
            if (i == line.Length || (line[i] == ';' && !quoted))
            {
                parts.Add(Statement.Parse(line.AsSpan(start, i - start)));
                start = i + 1;
            }
            else if (line[i] == '"')
            {
                quoted = !quoted;
            }
        }

        return [.. parts];
    }

    /// <summary>Removes blanks and tabs outside quotes, except one after two leading letters: it distinguishes "MG x=5" from the variable MGx.</summary>
    public static string Compact(ReadOnlySpan<char> text)
    {
        text = text.Trim(" \t");
        if (text.IndexOfAny(' ', '\t') < 0) return text.ToString();

        var compact = new StringBuilder(text.Length);
        var quoted = false;
        foreach (var c in text)
        {
            quoted ^= c == '"';
            var blank = c is ' ' or '\t' && !quoted;
            if (!blank || (compact.Length == 2 && char.IsAsciiLetterUpper(compact[0]) && char.IsAsciiLetterUpper(compact[1])))
                compact.Append(blank ? ' ' : c);
        }

        return compact.ToString();
    }
}
