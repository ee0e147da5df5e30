using System.CommandLine;

namespace Engraver.Cli.Verbs;

internal static class JsonOption
{
    public static Option<bool> New() => new("--json") { Description = Wording.Get("JsonOption.OneJsonObjectOn") };
}
