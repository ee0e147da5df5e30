using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>ROTATE: Rotates objects about a point, counter-clockwise.</summary>
internal sealed class RotateCommand : ICommand
{
    private const double MaxAngle = 1e6;

    public CommandInfo Info { get; } = new("ROTATE", CommandGroup.Drawing);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var selected = await ObjectSelection.GetForEditAsync(context, takesTexts: true).ConfigureAwait(false);
        var ghost = new SelectionGhost(context.Drawing, selected);
        var basePoint = await context.ValueAsync(new PointPrompt(Wording.Get("Editing.SpecifyBasePoint"))).ConfigureAwait(false);
        var amount = await ReferencePrompts.AskAsync(context, Degrees(Wording.Get("Rotate.SpecifyRotationAngle"), context.LastValue("ROTATE", "0"), basePoint), Degrees(Wording.Get("Rotate.SpecifyReferenceAngle"), "0", null), Degrees(Wording.Get("Rotate.SpecifyNewAngle"), null, basePoint), Turned).ConfigureAwait(false);
        var degrees = amount.Value - (amount.Reference ?? 0.0);
        if (amount.Reference is null) context.Remember("ROTATE", NumberPrompt.Format(degrees));
        DrawingChange.Transform(context, selected, Transform2D.Rotate(basePoint, Angle.FromDegrees(degrees)), amount.Copy);

        IReadOnlyList<Segment> Turned(double value, double? reference) => ghost.Mapped(Transform2D.Rotate(basePoint, Angle.FromDegrees(value - (reference ?? 0.0))));
    }

    private static AmountPrompt Degrees(string instruction, string? standard, Point2D? from) =>
        new(instruction, way => way.Direction.Positive().Degrees) { Default = standard, Min = -MaxAngle, Max = MaxAngle, From = from };
}
