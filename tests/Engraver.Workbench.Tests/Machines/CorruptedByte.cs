using System.Text;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>Corrupts one byte of one line, from a seed: a digit or letter changed, dropped, doubled, or another one inserted before it.</summary>
internal static class CorruptedByte
{
    private const string Digits = "0123456789";
    private const string Letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

    /// <param name="line">The sent line. Only digits, letters and signs are changed, so that a line remains one line.</param>
    /// <returns>The corrupted line; null if there is nothing to change.</returns>
    public static string? Of(string line, Random random)
    {
        var places = Enumerable.Range(0, line.Length).Where(i => char.IsAsciiLetterOrDigit(line[i]) || line[i] is '-' or '.').ToList();
        if (places.Count == 0) return null;
        var place = places[random.Next(places.Count)];
        var text = new StringBuilder(line);
        switch (random.Next(4))
        {
            case 0: text[place] = Another(line[place], random); break;
            case 1: text.Remove(place, 1); break;
            case 2: text.Insert(place, line[place]); break;
            default: text.Insert(place, Another(line[place], random)); break;
        }

        return text.ToString();
    }

    /// <summary>Another character of the same kind: a digit for a digit, a letter for a letter.</summary>
    private static char Another(char old, Random random)
    {
        var kind = char.IsAsciiLetter(old) ? Letters : Digits;
        var other = old;
        while (other == old) other = kind[random.Next(kind.Length)];
        return char.IsAsciiLetterLower(old) ? char.ToLowerInvariant(other) : other;
    }
}
