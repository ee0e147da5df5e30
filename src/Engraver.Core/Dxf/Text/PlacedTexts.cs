using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Tags;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Text;

/// <summary>Transforms a text by a placement: its line rotates with the x axis, its height is the component of the y axis perpendicular to that.</summary>
internal static class PlacedTexts
{
    public static PlacedText Placed(PlacedText text, in Placement placement)
    {
        var along = placement.ApplyToDirection(new Vector3D(text.Rotation.Cos(), text.Rotation.Sin(), 0.0));
        var across = placement.ApplyToDirection(new Vector3D(-text.Rotation.Sin(), text.Rotation.Cos(), 0.0));
        var stretch = double.Hypot(along.X, along.Y);
        var area = (along.X * across.Y) - (along.Y * across.X);
        var height = stretch > 0.0 ? Math.Abs(area) / stretch : 0.0;
        return text with
        {
            Position = placement.Apply(text.Position),
            End = text.End is { } end ? placement.Apply(end) : null,
            Height = text.Height * height,
            Rotation = stretch > 0.0 ? Angle.Direction(along.X, along.Y) : text.Rotation,
            WidthFactor = height > 0.0 ? text.WidthFactor * stretch / height : text.WidthFactor,
            FrameWidth = text.FrameWidth * stretch,
            Mirrored = text.Mirrored ^ (area < 0.0),
        };
    }

    public static bool IsInRange(PlacedText text) =>
        IsInRange(text.Position) && (text.End is not { } end || IsInRange(end)) && Fits(text.Height) && Fits(text.WidthFactor) && Fits(text.FrameWidth);

    private static bool IsInRange(Vector3D point) => Fits(point.X) && Fits(point.Y) && Fits(point.Z);

    private static bool Fits(double value) => Math.Abs(value) <= DxfNumber.Largest;
}
