using System.CommandLine;

namespace Engraver.Cli.Verbs;

internal static class JsonOption
{
    public static Option<bool> New() => new("--json") { Description = "One JSON object on standard output and nothing else." };
}
