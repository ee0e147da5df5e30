using Engraver.Core.Machines.Origins;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCZERO: Sets the active work origin so that the current machine position is the drawing's zero or a typed point; with Height the tool is at a
/// typed height of the drawing, such as the thickness of a feeler gauge.</summary>
internal sealed class CncZeroCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_axes = Keyword.List("All", "X", "Y", "Z", "Point", "Height", "Edges", "Centre");

    public CommandInfo Info { get; } = new("CNCZERO", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Lease is not { Memory: var before }) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        if (context.Machine.IsRunning) throw new CommandException(CommandFailure.Refused, Wording.Get("CncOrigin.JobRuns"));
        var axes = await context.ChoiceAsync(Wording.Get("CncZero.EnterAxes", before.Active), s_axes, "All").ConfigureAwait(false);
        if (axes is "Edges" or "Centre")
        {
            await (axes == "Edges" ? TouchedZero.ByEdgeAsync(context, cancellation) : TouchedZero.ByCentreAsync(context, cancellation)).ConfigureAwait(false);
            return;
        }

        if (axes is "Z" or "Height" && context.Machine.Profile.Axes.Z is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncZero.NoZAxis"));
        var place = axes == "Point" ? await context.ValueAsync(new PointPrompt(Wording.Get("CncZero.SpecifyPoint"))).ConfigureAwait(false) : default;
        var height = axes == "Height" ? await context.ValueAsync(new NumberPrompt(Wording.Get("CncZero.SpecifyHeight"))).ConfigureAwait(false) : 0.0;
        if (IsSet(before, axes) && !await context.ConfirmAsync(Wording.Get("CncZero.ConfirmReplace", before.Active)).ConfigureAwait(false)) return;
        var touch = new ZeroTouch { X = axes is not ("Y" or "Z" or "Height"), Y = axes is not ("X" or "Z" or "Height"), Z = axes is "Z" or "Height" or "All", Place = place, Height = height };
        if (!touch.IsCountable(context.Machine.Profile.Scale)) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.PositionOutOfRange"));
        var part = context.Machine.Runs.Part;
        await OriginText.SetAsync(context, touch, cancellation).ConfigureAwait(false);
        OriginText.WarnResumeDropped(context, part);
    }

    /// <summary>True if the operator has set the origin of one of these axes: the command asks before it is overwritten.</summary>
    private static bool IsSet(StoredMachineState memory, string axes) => memory.ActiveOrigin is { IsAssumed: false } origin &&
        ((axes is not ("Y" or "Z" or "Height") && origin.X is not null) || (axes is not ("X" or "Z" or "Height") && origin.Y is not null) || (axes is "Z" or "Height" or "All" && origin.Z is not null));
}
