using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Commands.Inquiry;
using Engraver.Workbench.Objects;

namespace Engraver.Workbench.Commands.Properties;

/// <summary>All object properties in display order, and the common values of several objects.</summary>
public static class ObjectProperties
{
    /// <summary>Maximum number of objects of which all properties are compared; of more only the general ones.</summary>
    private const int MaxMeasured = 5_000;

    /// <summary>AutoCAD's text for differing values.</summary>
    public const string Varies = "*VARIES*";

    public static IReadOnlyList<ObjectProperty> All { get; } =
    [
        new("Type", true) { Read = (facts, _) => facts.Entity.Type.ToDxfName() },
        new("Handle", true) { Read = (facts, _) => facts.Handle },
        new("LAyer", true) { Read = (facts, _) => facts.Drawing.Layers[facts.Entity.Layer].Name, Entity = PropertyEdit.OnLayer, Choices = drawing => [.. drawing.Layers.Select(layer => layer.Name)] },
        new("Color", true) { Read = (facts, _) => ColourName.OfObject(facts.Entity.Colour), Entity = PropertyEdit.InColour },
        new("SourceLine", true) { Read = (facts, _) => facts.Entity.SourceLine.ToString(CultureInfo.InvariantCulture) },
        .. TextProperties.All,
        ObjectProperty.Length("StartX", facts => facts.Start?.X) with { Change = (facts, x) => PropertyEdit.WithEnd(facts, facts.Start!.Value with { X = x }, atStart: true) },
        ObjectProperty.Length("StartY", facts => facts.Start?.Y) with { Change = (facts, y) => PropertyEdit.WithEnd(facts, facts.Start!.Value with { Y = y }, atStart: true) },
        ObjectProperty.Length("EndX", facts => facts.End?.X) with { Change = (facts, x) => PropertyEdit.WithEnd(facts, facts.End!.Value with { X = x }, atStart: false) },
        ObjectProperty.Length("EndY", facts => facts.End?.Y) with { Change = (facts, y) => PropertyEdit.WithEnd(facts, facts.End!.Value with { Y = y }, atStart: false) },
        ObjectProperty.Length("CenterX", facts => Centre(facts)?.X) with { Change = (facts, x) => PropertyEdit.Moved(facts, new Vector2D(x - Centre(facts)!.Value.X, 0.0)) },
        ObjectProperty.Length("CenterY", facts => Centre(facts)?.Y) with { Change = (facts, y) => PropertyEdit.Moved(facts, new Vector2D(0.0, y - Centre(facts)!.Value.Y)) },
        ObjectProperty.Length("Radius", facts => facts.Round?.Radius) with { Change = PropertyEdit.WithRadius },
        ObjectProperty.Length("Diameter", facts => facts.Circle?.Radius * 2.0) with { Change = (facts, diameter) => PropertyEdit.WithRadius(facts, diameter / 2.0) },
        ObjectProperty.Angle("StartAngle", facts => facts.Arc?.Start.Positive()) with { Change = (facts, degrees) => PropertyEdit.WithAngles(facts, degrees, EndAngle(facts.Arc!.Value).Degrees) },
        ObjectProperty.Angle("EndAngle", facts => facts.Arc is { } arc ? EndAngle(arc) : null) with { Change = (facts, degrees) => PropertyEdit.WithAngles(facts, facts.Arc!.Value.Start.Degrees, degrees) },
        ObjectProperty.Angle("TotalAngle", facts => facts.Arc?.Sweep),
        ObjectProperty.Length("DeltaX", facts => facts.Line is { } line ? line.End.X - line.Start.X : null),
        ObjectProperty.Length("DeltaY", facts => facts.Line is { } line ? line.End.Y - line.Start.Y : null),
        ObjectProperty.Angle("Angle", facts => facts.Line is { } line ? (line.End - line.Start).Direction.Positive() : null),
        new("Vertices", false) { Read = (facts, _) => facts.IsPolyline ? (facts.Segments.Count + (facts.Entity.Closed ? 0 : 1)).ToString(CultureInfo.InvariantCulture) : null },
        ObjectProperty.Length("Length", facts => facts.Circle is null && facts.Text is null ? facts.Length : null),
        ObjectProperty.Length("CircumFerence", facts => facts.Circle is null ? null : facts.Length) with { Change = (facts, length) => PropertyEdit.WithRadius(facts, length / (2.0 * Math.PI)) },
        new("Area", false) { Read = (facts, figures) => facts.Line is null && facts.Segments.Count > 0 ? figures.FormatArea(ClosedArea.Measure(facts.Segments)) : null },
        new("CLosed", false)
        {
            Read = (facts, _) => facts.Text is null ? ClosedProperty.Format(facts.IsPolyline ? facts.Entity.Closed : facts.IsClosed) : null,
            Closed = ClosedProperty.Parse,
            Allows = facts => facts.IsPolyline,
            Choices = _ => [ClosedProperty.Format(true), ClosedProperty.Format(false)],
        },
    ];

    /// <summary>The common properties of some objects with their common values. A property that one object lacks is omitted.</summary>
    public static IReadOnlyList<PropertyValue> Of(Drawing drawing, IReadOnlyList<int> objects, DisplayPrecision figures)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(objects);
        var measured = All.Where(property => property.IsGeneral || objects.Count <= MaxMeasured).ToArray();
        var (values, editable) = (new string?[measured.Length], new bool[measured.Length]);
        for (var at = 0; at < objects.Count; at++)
        {
            var facts = new ObjectFacts(drawing, objects[at]);
            for (var i = 0; i < measured.Length; i++)
            {
                values[i] = Combine(values[i], measured[i], facts, figures, isFirst: at == 0);
                editable[i] = (at == 0 ? measured[i].IsEditable : editable[i]) && measured[i].Allows(facts);
            }
        }

        return [.. measured.Select((property, i) => new PropertyValue(property, values[i] ?? "", editable[i], values[i] is not null)).Where(value => value.Exists)];
    }

    /// <summary>Null if one object lacks the property.</summary>
    private static string? Combine(string? before, ObjectProperty property, ObjectFacts facts, DisplayPrecision figures, bool isFirst)
    {
        if (!isFirst && (before is null || (before == Varies && property.IsGeneral))) return before;
        var value = property.Read(facts, figures);
        return isFirst || value is null || value == before ? value : Varies;
    }

    private static Angle EndAngle(ArcSegment arc) => (arc.Start + arc.Sweep).Positive();

    private static Point2D? Centre(ObjectFacts facts) => facts.Round?.Centre ?? (facts.Segments.Count == 1 ? ObjectGrips.CentreOf(facts.Segments[0]) : null);
}
