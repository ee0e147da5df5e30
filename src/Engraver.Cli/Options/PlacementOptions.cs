using System.CommandLine;
using System.CommandLine.Parsing;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary><c>--origin</c> and <c>--finish</c>: where the drawing's zero lies on the machine, and where the machine goes behind the last stroke.</summary>
internal sealed class PlacementOptions
{
    private readonly Option<OriginRequest> _origin = new("--origin")
    {
        HelpName = "work|here|X,Y",
        Description = Wording.Get("Placement.Origin"),
        DefaultValueFactory = _ => new OriginRequest.Work(),
        CustomParser = ParseOrigin,
    };

    private readonly Option<FinishPlace> _finish = new("--finish")
    {
        HelpName = "origin|stay|park",
        Description = Wording.Get("Placement.Finish"),
        CustomParser = ParseFinish,
    };

    public void AddTo(Command command)
    {
        command.Options.Add(_origin);
        command.Options.Add(_finish);
    }

    public OriginRequest Origin(ParseResult parsed) => parsed.GetValue(_origin)!;

    /// <exception cref="SettingException">The profile has no park position.</exception>
    public FinishPlace Finish(ParseResult parsed, MachineProfile profile) => parsed.GetValue(_finish) is FinishPlace.Park && profile.Park is null
        ? throw new SettingException(Wording.Get("Placement.NoPark"))
        : parsed.GetValue(_finish);

    /// <summary>Who runs, for another host that comes meanwhile.</summary>
    public static string Holder => MachineHolder.Describe("engraver", TimeProvider.System);

    /// <summary>The origins of the operator's machines; a simulated one ends with this process, and nothing is kept of it.</summary>
    public static MachineMemories Memories(ControllerAddress address) => new(address is SimulatedAddress ? null : MachineMemories.FolderIn(null));

    private static OriginRequest ParseOrigin(ArgumentResult result)
    {
        var word = result.Tokens[0].Value;
        if (word == "work") return new OriginRequest.Work();
        if (word == "here") return new OriginRequest.PresentPlace();
        if (TryPlace(word) is { } place) return new OriginRequest.Given(place);
        result.AddError(Wording.Get("Placement.NoOrigin", word));
        return new OriginRequest.Work();
    }

    /// <summary>X,Y in millimetres; null when it is no such thing.</summary>
    internal static Point2D? TryPlace(string word) =>
        word.Split(',') is [var first, var second] && NumberPrompt.TryNumber(first, out var x) && NumberPrompt.TryNumber(second, out var y) && double.IsFinite(x) && double.IsFinite(y) ? new Point2D(x, y) : null;

    private static FinishPlace ParseFinish(ArgumentResult result)
    {
        switch (result.Tokens[0].Value)
        {
            case "origin": return FinishPlace.Origin;
            case "stay": return FinishPlace.Stay;
            case "park": return FinishPlace.Park;
            default:
                result.AddError(Wording.Get("Placement.NoFinish", result.Tokens[0].Value));
                return FinishPlace.Origin;
        }
    }
}
