using System.CommandLine;
using Engraver.Core.Machines;

namespace Engraver.Cli.Options;

/// <summary><c>--mode</c>: how a job is run on the controller.</summary>
internal static class ModeOption
{
    public static Option<string> New()
    {
        var option = new Option<string>("--mode") { Description = "stream: vector sequences fed live; calls: the paper's #LINEAR and #CIRC; program: the job downloaded and run in the controller, chunk by chunk.", DefaultValueFactory = _ => "stream" };
        option.AcceptOnlyFromAmong("stream", "calls", "program");
        return option;
    }

    public static JobMode Mode(string? word) => word switch { "calls" => JobMode.Calls, "program" => JobMode.Program, _ => JobMode.Stream };
}
