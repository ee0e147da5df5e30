using System.CommandLine;
using Engraver.Core.Machines;

namespace Engraver.Cli.Options;

/// <summary><c>--mode</c>: how a job is run on the controller.</summary>
internal static class ModeOption
{
    public static Option<string> New()
    {
        var option = new Option<string>("--mode") { Description = Wording.Get("ModeOption.Mode"), DefaultValueFactory = _ => "stream" };
        option.AcceptOnlyFromAmong("stream", "calls", "program");
        return option;
    }

    public static JobMode Mode(string? word) => word switch { "calls" => JobMode.Calls, "program" => JobMode.Program, _ => JobMode.Stream };
}
