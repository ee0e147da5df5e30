using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Origins;

namespace Engraver.Cli.Options;

/// <summary><c>--origin</c>: where the drawing's zero is on the machine.</summary>
internal sealed class PlacementOptions
{
    private readonly Option<OriginRequest> _origin = new("--origin")
    {
        HelpName = "work|here|X,Y",
        Description = Wording.Get("Placement.Origin"),
        CustomParser = ParseOrigin,
    };

    public void AddTo(Command command)
    {
        command.Options.Add(_origin);
    }

    public OriginRequest Origin(ParseResult parsed) => parsed.GetValue(_origin) ?? new OriginRequest.ActiveOrigin();

    /// <summary>Whether the work origin was asked for by name, and is not just the default.</summary>
    public bool RequestsWorkOrigin(ParseResult parsed) => parsed.GetResult(_origin) is { Implicit: false } && Origin(parsed) is OriginRequest.ActiveOrigin;

    /// <summary>The name of this process for another host that requests the machine meanwhile.</summary>
    public static string OwnerName => LeaseOwner.Describe("engraver", TimeProvider.System);

    /// <summary>The origins of the operator's machines; a simulated one ends with this process, and nothing is kept of it.</summary>
    public static MachineMemories Memories(ControllerAddress address) => new(address is SimulatedAddress ? null : MachineMemories.FolderIn(null));

    private static OriginRequest ParseOrigin(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (word == "work") return new OriginRequest.ActiveOrigin();
        if (word == "here") return new OriginRequest.PresentPosition();
        if (TryParsePosition(word) is { } place) return new OriginRequest.MachinePoint(place);
        result.AddError(Wording.Get("Placement.InvalidOrigin", word));
        return new OriginRequest.ActiveOrigin();
    }

    /// <summary>A place typed as X,Y, mm; null when the text is not a position.</summary>
    internal static Point2D? TryParsePosition(string word) =>
        word.Split(',') is [var first, var second] && NumberPrompt.TryParse(first, out var x) && NumberPrompt.TryParse(second, out var y) && double.IsFinite(x) && double.IsFinite(y) ? new Point2D(x, y) : null;
}
