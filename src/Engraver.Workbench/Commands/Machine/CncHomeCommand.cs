namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCHOME: Homes the machine as configured in its profile; afterwards the controller counts from the profile's zero.</summary>
internal sealed class CncHomeCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCHOME", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        ManualMotion.ThrowIfNotReady(context);
        var profile = context.Machine.Profile;
        if (!profile.HasHoming) throw new CommandException(CommandFailure.Usage, Wording.Get("CncHome.NoHoming"));
        foreach (var axis in profile.Axes.All.Where(axis => axis.Homing is not null).OrderBy(axis => axis.Homing!.Order)) context.WriteMessage(HomingText.Sentence(axis));
        if (context.Machine.Hand.OriginsLostByHoming is { Count: > 0 } lost) context.WriteMessage(Wording.Get("CncHome.OriginsNotRestored", string.Join(", ", lost)), MessageKind.Warning);
        if (!await context.ConfirmAsync(Wording.Get("CncHome.ConfirmStart")).ConfigureAwait(false)) return;
        ManualMotion.ThrowIfMotorsOff(context);
        var part = context.Machine.Runs.Part;
        var homed = await context.Machine.Hand.HomeAsync(context.NewRunJournal("home"), cancellation).ConfigureAwait(false);
        OriginText.WarnResumeDropped(context, part);
        if (homed.LostOrigins.Count > 0) context.WriteMessage(Wording.Get("CncHome.OriginsLost", string.Join(", ", homed.LostOrigins)), MessageKind.Warning);
        ManualMotion.ReportResult(context, homed.Result);
    }
}
