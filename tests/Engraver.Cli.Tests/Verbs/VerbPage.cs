using System.CommandLine;
using System.CommandLine.Completions;
using System.Globalization;
using System.Text;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>docs/verbs.md, generated from the command line definition.</summary>
internal static class VerbPage
{
    /// <summary>An option of at least this many verbs with the same meaning is listed in a common table.</summary>
    private const int Shared = 4;

    private const int WordsOfALine = 16;

    public static string Of(RootCommand root)
    {
        var verbs = root.Subcommands.SelectMany(verb => WithChildren(verb, "")).ToList();
        var shared = verbs.SelectMany(verb => verb.Command.Options).Where(IsShown).GroupBy(option => (option.Name, option.Description)).Where(option => option.Count() >= Shared).ToDictionary(option => option.Key, option => option.First());
        var page = new StringBuilder();
        page.Append("""
            # Verbs

            This page is generated from the command line of the program (`./test --update-golden`).
            Every verb also takes `--help`. [cli-contract.md](cli-contract.md) describes JSON output and what scripts can rely on;
            [exit-codes.md](exit-codes.md) lists the exit codes.

            | Verb | What it does |
            |---|---|

            """);
        foreach (var verb in verbs) page.Append(CultureInfo.InvariantCulture, $"| [`{verb.Name}`](#engraver-{verb.Name.Replace(' ', '-')}) | {Cell(verb.Command.Description)} |\n");
        foreach (var verb in verbs) Append(page, verb.Name, verb.Command, shared);
        page.Append("\n## Shared options\n\nThese options have the same meaning in every verb that takes them.\n\n");
        AppendOptions(page, shared.Values.OrderBy(option => option.Name, StringComparer.Ordinal));
        page.Append("\n## Global options\n\n");
        AppendOptions(page, root.Options.Where(IsShown));
        return page.ToString();
    }

    private static IEnumerable<(string Name, Command Command)> WithChildren(Command verb, string before) =>
        verb.Subcommands.SelectMany(child => WithChildren(child, $"{before}{verb.Name} ")).Prepend(($"{before}{verb.Name}", verb));

    private static void Append(StringBuilder page, string name, Command verb, Dictionary<(string, string?), Option> shared)
    {
        page.Append(CultureInfo.InvariantCulture, $"\n## engraver {name}\n\n{Lines(verb.Description)}\n\n    engraver {name}{string.Concat(verb.Arguments.Select(Usage))}{(verb.Options.Any(IsShown) ? " [options]" : "")}\n");
        if (verb.Arguments.Count > 0)
        {
            page.Append("\n| Argument | Meaning |\n|---|---|\n");
            foreach (var argument in verb.Arguments) page.Append(CultureInfo.InvariantCulture, $"| `{argument.HelpName ?? argument.Name}` | {Cell(argument.Description)} |\n");
        }

        var own = verb.Options.Where(option => IsShown(option) && !shared.ContainsKey((option.Name, option.Description))).ToList();
        if (own.Count > 0) page.Append('\n');
        AppendOptions(page, own);
        var others = verb.Options.Where(option => IsShown(option) && shared.ContainsKey((option.Name, option.Description))).Select(option => $"`{option.Name}`").ToList();
        if (others.Count > 0) page.Append(CultureInfo.InvariantCulture, $"\n[Shared options](#shared-options):\n{string.Join(",\n", others.Chunk(8).Select(names => string.Join(", ", names)))}\n");
    }

    private static void AppendOptions(StringBuilder page, IEnumerable<Option> options)
    {
        var all = options.ToList();
        if (all.Count == 0) return;
        page.Append("| Option | Value | Meaning |\n|---|---|---|\n");
        foreach (var option in all) page.Append(CultureInfo.InvariantCulture, $"| {string.Join(", ", option.Aliases.Prepend(option.Name).Distinct().Select(name => $"`{name}`"))} | {(option.ValueType == typeof(bool) ? "" : $"`{Cell(ValueOf(option))}`")} | {Cell(option.Description)} |\n");
    }

    /// <summary>Limits the line length, so that the page is readable as text.</summary>
    private static string Lines(string? text) => string.Join('\n', (text ?? "").Split(' ').Chunk(WordsOfALine).Select(words => string.Join(' ', words)));

    private static string ValueOf(Option option) => option.HelpName ?? (option.GetCompletions(CompletionContext.Empty).Select(value => value.Label).ToList() is { Count: > 0 } values ? string.Join('|', values) : "VALUE");

    private static string Usage(Argument argument) => argument.Arity.MinimumNumberOfValues == 0 ? $" [{argument.HelpName ?? argument.Name}]" : $" {argument.HelpName ?? argument.Name}";

    private static bool IsShown(Option option) => !option.Hidden && option.Name is not "--help" and not "--version";

    private static string Cell(string? text) => (text ?? "").Replace("|", "\\|", StringComparison.Ordinal).ReplaceLineEndings(" ").Trim();
}
