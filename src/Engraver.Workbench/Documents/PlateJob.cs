using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>Prepares the job of one plate.</summary>
public static class PlateJob
{
    /// <summary>Runs all stages up to the checked motion program, with the drawing in the cell of the plate.</summary>
    /// <param name="style">As for <see cref="JobPreparation"/>.</param>
    /// <param name="plate">Null for a drawing without plates.</param>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing, or the cell is outside the range of a drawing.</exception>
    public static PreparedJob Prepare(Drawing drawing, DrawingSettings settings, MotionStyle style, Plate? plate, CancellationToken cancellation = default) =>
        PreparedJob.From(new StageRun(Drawn(drawing, settings, style, plate), cancellation).To<CheckedJob>()) with { Plate = plate };

    /// <summary>What the preparation of a plate starts with.</summary>
    /// <param name="plate">Null for a drawing without plates.</param>
    /// <exception cref="SettingException">The cell is outside the range of a drawing.</exception>
    internal static DrawnJob Drawn(Drawing drawing, DrawingSettings settings, MotionStyle style, Plate? plate) =>
        new(plate is null ? drawing : At(drawing, plate.Offset), settings, style) { Source = drawing, Values = plate?.Values ?? PlateValues.None };

    /// <summary>The drawing moved by millimetres: curves, texts and points.</summary>
    private static Drawing At(Drawing drawing, Vector2D offset)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        if (offset == default) return drawing;
        int[] objects = [.. Enumerable.Range(0, drawing.Entities.Count + drawing.Texts.Count)];
        var map = Transform2D.Move(new Vector2D(drawing.Scale.ToDrawing(offset.X), drawing.Scale.ToDrawing(offset.Y)));
        if (!DrawingEdit.TryTransform(drawing, objects.Take(drawing.Entities.Count), map, out var moved)) throw new SettingException(Wording.Get("DrawingChange.OutOfRange"));
        return EditedAnnotations.For(drawing, objects, takesLocked: true, keepsTextDirection: false).Moved(moved, map) with { PlacementMap = map.After(drawing.PlacementMap) };
    }
}
