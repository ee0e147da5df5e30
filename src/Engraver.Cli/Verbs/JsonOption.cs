using System.CommandLine;

namespace Engraver.Cli.Verbs;

internal static class JsonOption
{
    public const string Name = "--json";

    public static Option<bool> New() => new(Name) { Description = Wording.Get("JsonOption.Json") };
}
