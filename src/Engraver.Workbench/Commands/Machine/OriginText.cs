using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>Text of work origins for display.</summary>
internal static class OriginText
{
    /// <param name="origin">Null if it was never set.</param>
    public static string Sentence(string name, WorkOrigin? origin, MachineProfile profile)
    {
        if (origin is null) return Wording.Get("Origins.NotSet", name);
        string[] axes = [.. origin.ToMillimetres(profile).Select(axis => axis is { } set ? Wording.Get("Origins.Millimetres", set) : Wording.Get("Origins.AxisNotSet"))];
        var place = axes.Length == 2 ? Wording.Get("Origins.Place", axes[0], axes[1]) : Wording.Get("Origins.PlaceWithZ", axes[0], axes[1], axes[2]);
        return Wording.Get(origin.IsAssumed ? "Origins.Assumed" : "Origins.IsSet", name, place);
    }

    /// <summary>Sets the active origin at the current machine position and reports it.</summary>
    /// <exception cref="CommandException">The machine position is uncertain.</exception>
    public static async Task SetAsync(CommandContext context, ZeroTouch touch, CancellationToken cancellation)
    {
        var machine = context.Machine;
        if (await machine.Origins.SetAsync((memory, here) => touch.Set(memory, memory.Active, here.Position, machine.Profile), cancellation).ConfigureAwait(false) is { } refusal) throw new CommandException(CommandFailure.Refused, SettingWording.AtCommandLine(refusal).Message);
        if (touch.Z) machine.Runs.NoteHeight();
        var memory = machine.Connection.Lease!.Memory;
        context.WriteMessage(Sentence(memory.Active, memory.ActiveOrigin, machine.Profile), MessageKind.Result);
    }

    /// <summary>Warns that START now cuts the whole drawing, because the change of the origin discarded the selected part.</summary>
    /// <param name="before">The part that was selected before.</param>
    public static void WarnResumeDropped(CommandContext context, JobPart? before)
    {
        if (before is not null && context.Machine.Runs.Part is null) context.WriteMessage(Wording.Get("Origins.ResumeDropped"), MessageKind.Warning);
    }
}
