using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;

namespace Engraver.Workbench.Commands.Sequencing;

/// <summary>DISCONTINUITIES: Lists every end of an open contour with the gap to the nearest other one.</summary>
internal sealed class DiscontinuitiesCommand : ICommand
{
    public CommandInfo Info { get; } = new("DISCONTINUITIES", CommandGroup.Sequence);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var settings = context.Document.Current.Settings;
        var result = JobPreparation.Sequence(drawing, JobPreparation.Analyse(drawing, settings), settings);
        context.SayResult(output => SequenceText.WriteOpenEnds(output, result));
        return Task.CompletedTask;
    }
}
