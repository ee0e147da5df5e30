using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>Prepares the job of one plate.</summary>
public static class PlateJob
{
    /// <summary>Runs all stages up to the checked motion program, with the drawing in the cell of the plate.</summary>
    /// <param name="style">As for <see cref="JobPreparation"/>.</param>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing, or the cell is outside the range of a drawing.</exception>
    public static PreparedJob Prepare(Drawing drawing, DrawingSettings settings, MotionStyle style, Plate plate)
    {
        ArgumentNullException.ThrowIfNull(plate);
        return JobPreparation.Prepare(At(drawing, plate.Offset), settings, style, plate.Values) with { Plate = plate };
    }

    /// <summary>The drawing moved by millimetres: curves, texts and points.</summary>
    private static Drawing At(Drawing drawing, Vector2D offset)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        if (offset == default) return drawing;
        int[] objects = [.. Enumerable.Range(0, drawing.Entities.Count + drawing.Texts.Count)];
        var map = Transform2D.Move(new Vector2D(drawing.Scale.ToDrawing(offset.X), drawing.Scale.ToDrawing(offset.Y)));
        if (!DrawingEdit.TryTransform(drawing, objects.Take(drawing.Entities.Count), map, out var moved)) throw new SettingException(Wording.Get("DrawingChange.OutOfRange"));
        return EditedAnnotations.For(drawing, objects, takesLocked: true, keepsTextDirection: false).Moved(moved, map);
    }
}
