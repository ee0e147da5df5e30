using Engraver.Core.Kerf;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Commands.Sequencing;

/// <summary>DISCONTINUITIES: Lists every end of an open contour with the gap to the nearest other one.</summary>
internal sealed class DiscontinuitiesCommand : ICommand
{
    public CommandInfo Info { get; } = new("DISCONTINUITIES", CommandGroup.Sequence);

    public Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var result = JobPreparation.To<OrderedJob>(context.Drawing, context.Document.Current.Settings with { Kerf = KerfSide.Off, Operations = null }, context.PlateValues).Sequence;
        context.WriteResult(output => SequenceText.WriteOpenEnds(output, result));
        return Task.CompletedTask;
    }
}
