using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>SCALE: Enlarges or shrinks objects from a point.</summary>
internal sealed class ScaleCommand : ICommand
{
    private const double MinFactor = 1e-6;
    private const double MaxFactor = 1e6;

    public CommandInfo Info { get; } = new("SCALE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetForEditAsync(context, takesTexts: true).ConfigureAwait(false);
        var ghost = new SelectionGhost(context.Drawing, selected);
        var basePoint = await context.ValueAsync(new PointPrompt(Wording.Get("Editing.SpecifyBasePoint"))).ConfigureAwait(false);
        var amount = await ReferencePrompts.AskAsync(context, Length(Wording.Get("Scale.SpecifyScaleFactor"), context.LastValue("SCALE", "1"), basePoint), Length(Wording.Get("Scale.SpecifyReferenceLength"), "1", null), Length(Wording.Get("Scale.SpecifyNewLength"), null, basePoint), Scaled).ConfigureAwait(false);
        var factor = amount.Value / (amount.Reference ?? 1.0);
        if (amount.Reference is null) context.Remember("SCALE", NumberPrompt.Format(factor));
        DrawingChange.Transform(context, selected, Transform2D.ScaleFrom(basePoint, factor), amount.Copy);

        IReadOnlyList<Segment> Scaled(double value, double? reference) => ghost.Mapped(Transform2D.ScaleFrom(basePoint, value / (reference ?? 1.0)));
    }

    private static AmountPrompt Length(string instruction, string? standard, Point2D? from) => new(instruction, way => way.Length) { Default = standard, Min = MinFactor, Max = MaxFactor, From = from };
}
