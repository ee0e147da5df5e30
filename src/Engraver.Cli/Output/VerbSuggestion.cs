using System.CommandLine;

namespace Engraver.Cli.Output;

/// <summary>Suggests the nearest verb for a word that is none.</summary>
internal static class VerbSuggestion
{
    /// <summary>Null when the first word is a verb or an option, so that something else is wrong.</summary>
    public static string? For(string[] args, RootCommand root)
    {
        if (args.Length == 0 || args[0].StartsWith('-') || root.Subcommands.Any(verb => verb.Name == args[0])) return null;
        var nearest = root.Subcommands.MinBy(verb => Distance(args[0], verb.Name));
        return nearest is not null && Distance(args[0], nearest.Name) <= Math.Max(1, args[0].Length / 2)
            ? Wording.Get("VerbSuggestion.ThereNoVerbDid", args[0], nearest.Name)
            : Wording.Get("VerbSuggestion.ThereNoVerbThere", args[0], string.Join(", ", root.Subcommands.Select(verb => verb.Name)));
    }

    /// <summary>Levenshtein: letters to change, add or leave out.</summary>
    private static int Distance(string typed, string verb)
    {
        var row = Enumerable.Range(0, verb.Length + 1).ToArray();
        for (var i = 1; i <= typed.Length; i++)
        {
            var (diagonal, before) = (row[0], row[0] = i);
            for (var j = 1; j <= verb.Length; j++)
            {
                before = Math.Min(Math.Min(before, row[j]) + 1, diagonal + (char.ToLowerInvariant(typed[i - 1]) == verb[j - 1] ? 0 : 1));
                (diagonal, row[j]) = (row[j], before);
            }
        }

        return row[^1];
    }
}
