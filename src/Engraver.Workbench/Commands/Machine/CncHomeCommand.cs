using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCHOME: Homes the machine as configured in its profile; afterwards the controller counts from the profile's zero.</summary>
internal sealed class CncHomeCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCHOME", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        HandMotion.Check(context);
        var profile = context.Machine.Profile;
        if (!profile.HasHoming) throw new CommandException(CommandFailure.Usage, Wording.Get("CncHome.NoHoming"));
        foreach (var axis in profile.Axes.All.Where(axis => axis.Homing is not null).OrderBy(axis => axis.Homing!.Order)) context.Say(HomingText.Sentence(axis));
        if (context.Machine.Hand.HomingForgets is { Count: > 0 } lost) context.Say(Wording.Get("CncHome.OriginsNotRestored", string.Join(", ", lost)), MessageKind.Warning);
        if (!await context.ConfirmAsync(Wording.Get("CncHome.ConfirmStart")).ConfigureAwait(false)) return;
        HandMotion.CheckMotors(context);
        var part = context.Machine.Runs.Part;
        var homed = await context.Machine.Hand.HomeAsync(context.NewRunJournal("home"), cancellation).ConfigureAwait(false);
        OriginText.TellPart(context, part);
        if (homed.Forgotten.Count > 0) context.Say(Wording.Get("CncHome.OriginsLost", string.Join(", ", homed.Forgotten)), MessageKind.Warning);
        HandMotion.Conclude(context, homed.Result);
    }
}

/// <summary>Description of the homing of an axis.</summary>
internal static class HomingText
{
    public static string Sentence(MachineAxis axis)
    {
        var homing = axis.Homing!;
        var (mark, way) = (Wording.Get("HomingMark." + homing.By), homing.Plus ? Wording.Get("CncHome.Plus") : Wording.Get("CncHome.Minus"));
        return Wording.Get("CncHome.Axis", axis.Letter, mark, way, homing.Zero, homing.FastMmPerMinute, homing.SlowMmPerMinute, homing.BackOff);
    }
}
