using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Sequencing;

/// <summary>CHECK: Lists everything that is wrong or doubtful in the drawing and its motion; fails if there is an error.</summary>
internal sealed class CheckCommand : ICommand
{
    public CommandInfo Info { get; } = new("CHECK", CommandGroup.Ask);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var job = JobPreparation.PrepareUnlessCancelled(drawing, context.Document.Current.Settings, MotionStyle.Continuous, cancellation, context.PlateValues);
        FindingMessages.Write(context, drawing.FileName, job.Diagnostics, Severity.Info);
        var errors = job.Diagnostics.Count(found => found.Severity == Severity.Error);
        var warnings = job.Diagnostics.Count(found => found.Severity == Severity.Warning);
        context.WriteMessage($"{CountText.Format(errors, "Error")}, {CountText.Format(warnings, "Warning")}.", MessageKind.Result);
        if (errors > 0) throw new CommandException(CommandFailure.Drawing, Wording.Get("Check.DrawingHas", CountText.Format(errors, "Error")));
        return Task.CompletedTask;
    }
}
