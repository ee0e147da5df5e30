namespace Engraver.Core.Languages;

/// <summary>Finds the word that was probably meant by an unknown one: a verb, a field.</summary>
public static class NearestWord
{
    /// <summary>The known word with the fewest letters to change, at most half of those typed, ignoring case; otherwise the shortest one that begins with the
    /// typed text, or with which the typed text begins. Null: none is similar.</summary>
    public static string? Find(string typed, IEnumerable<string> known)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var words = known.ToList();
        var nearest = words.MinBy(word => Distance(typed, word));
        if (nearest is not null && Distance(typed, nearest) <= Math.Max(1, typed.Length / 2)) return nearest;
        return typed.Length < 2 ? null : words.Where(word => word.StartsWith(typed, StringComparison.OrdinalIgnoreCase) || (word.Length > 2 && typed.StartsWith(word, StringComparison.OrdinalIgnoreCase))).MinBy(word => word.Length);
    }

    /// <summary>Number of letters to change, add or leave out (Levenshtein), ignoring case.</summary>
    private static int Distance(string typed, string word)
    {
        var row = Enumerable.Range(0, word.Length + 1).ToArray();
        for (var i = 1; i <= typed.Length; i++)
        {
            var (diagonal, before) = (row[0], row[0] = i);
            for (var j = 1; j <= word.Length; j++)
            {
                before = Math.Min(Math.Min(before, row[j]) + 1, diagonal + (char.ToLowerInvariant(typed[i - 1]) == char.ToLowerInvariant(word[j - 1]) ? 0 : 1));
                (diagonal, row[j]) = (row[j], before);
            }
        }

        return row[^1];
    }
}
