using System.Text;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Reads AutoCAD's script format: one stream of inputs, where a space and an end of line both mean Enter. So a blank line is Enter alone, two spaces
/// include an extra Enter, and a trailing space ends a selection. A line that begins with <c>;</c> is a comment; double quotes hold a file name with spaces
/// together.</summary>
public static class ScriptText
{
    public static IEnumerable<ScriptToken> Read(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var lines = text.ReplaceLineEndings("\n").Split('\n');
        var count = lines[^1].Length == 0 ? lines.Length - 1 : lines.Length;
        for (var number = 1; number <= count; number++)
        {
            if (lines[number - 1].StartsWith(';')) continue;
            foreach (var input in Inputs(lines[number - 1])) yield return new ScriptToken(number, input);
        }
    }

    /// <summary>An input in the form that is read back unchanged: inputs with spaces are quoted.</summary>
    public static string Write(string input)
    {
        ArgumentNullException.ThrowIfNull(input);
        return input.Contains(' ', StringComparison.Ordinal) || input.StartsWith(';') ? $"\"{input}\"" : input;
    }

    private static IEnumerable<string> Inputs(string line)
    {
        var input = new StringBuilder();
        var quoted = false;
        foreach (var letter in line)
        {
            if (letter == '"') quoted = !quoted;
            else if (letter is ' ' or '\t' && !quoted)
            {
                yield return input.ToString();
                input.Clear();
            }
            else input.Append(letter);
        }

        yield return input.ToString();
    }
}
