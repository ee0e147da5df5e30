using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCFRAME: Moves once around the job with the tool off, at the active work origin: along the bounding rectangle or the convex hull of the
/// cut.</summary>
internal sealed class CncFrameCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_shapes = Keyword.List([.. Enum.GetNames<FrameShape>()]);

    public CommandInfo Info { get; } = new("CNCFRAME", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is not { } machine) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        _ = context.Drawing;
        if (context.RequiresManualStart) throw new CommandException(CommandFailure.Usage, Wording.Get("CncGoTo.ScriptCannotMove"));
        if (context.IsScripted && !context.Machine.Connection.IsSimulation && context.Machine.Arming.Armed is null) throw new CommandException(CommandFailure.Usage, Wording.Get("CncFrame.ScriptNeedsArming", machine));
        var shape = Enum.Parse<FrameShape>(await context.ChoiceAsync(Wording.Get("CncFrame.EnterShape"), s_shapes, context.LastValue("CNCFRAME", nameof(FrameShape.Rectangle))).ConfigureAwait(false));
        context.Remember("CNCFRAME", shape.ToString());
        if (context.Machine.Status.MotorsOn == false) throw new CommandException(CommandFailure.Refused, Wording.Get("CncGoTo.MotorsOff"));
        var job = await JobStart.PrepareAsync(context, context.Driver.DefaultStrategy).ConfigureAwait(false);
        var frame = JobFrame.Of(job, shape) ?? throw new CommandException(CommandFailure.Drawing, $"{job.NoProgramReason}.");
        var result = await context.Machine.Runs.FrameAsync(frame, context.NewRunJournal("frame"), cancellation).ConfigureAwait(false);
        FindingMessages.Write(context, job.Drawing.FileName, result.Diagnostics, Severity.Warning);
        foreach (var left in result.NotRestored) context.WriteMessage(Wording.Get("Machine.NotRestored", left), MessageKind.Warning);
        if (result.FrameOrigin is null && result.Outcome == JobOutcome.Refused) throw new CommandException(CommandFailure.Refused, result.Diagnostics.Count > 0 ? Wording.Get("JobStart.WorkOriginUnknown") : result.Message);
        if (result.Outcome != JobOutcome.Complete) throw JobStart.Failure(result);
        context.WriteMessage(Wording.Get("CncFrame.Done"), MessageKind.Result);
    }
}
