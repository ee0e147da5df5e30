using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Text;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Commands.Texts;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Objects;

namespace Engraver.Workbench.Commands.Properties;

/// <summary>Changes a property of objects to a typed value: all of them or none.</summary>
internal static class PropertyEdit
{
    /// <returns>The drawing with the new value.</returns>
    /// <exception cref="CommandException">The value is invalid, or an object cannot have it; the message states which and why.</exception>
    public static Drawing Apply(Drawing drawing, IReadOnlyList<int> objects, ObjectProperty property, string typed, DisplayPrecision figures)
    {
        var having = objects.Select(index => new ObjectFacts(drawing, index)).Where(facts => property.Read(facts, figures) is not null && property.Allows(facts)).ToList();
        if (having.Count == 0) throw new CommandException(CommandFailure.Usage, Wording.Get("ChProp.PropertyNotFound", property.Title));
        if (property.OfText is { } change) return TextsChanged(drawing, having, property, typed, change);
        if (property.Entity is { } entity)
        {
            var edited = drawing with { Entities = drawing.Entities.With(having.Where(facts => facts.Text is null).Select(facts => (facts.Index, entity(facts, typed))), []) };
            return TextsChanged(edited, [.. having.Where(facts => facts.Text is not null)], property, typed, (facts, text, _) => entity(facts, typed) is var like ? text with { Layer = like.Layer, Colour = like.Colour } : text);
        }

        if (property.Closed is { } closed) return ClosedProperty.Apply(drawing, having, closed(typed));
        if (!NumberPrompt.TryParse(typed.Trim(), out var value)) throw new CommandException(CommandFailure.Usage, Wording.Get("ChProp.NotANumber", typed, property.Title));
        var changes = new List<ChangedPart>();
        foreach (var facts in having)
        {
            if (property.Change!(facts, value) is not { } parts || !parts.All(part => part.IsSound)) throw new CommandException(CommandFailure.Usage, Wording.Get("ChProp.ValueNotPossible", property.Title, typed, Named(facts)));
            changes.AddRange(parts);
        }

        return ChangedPart.Apply(drawing, changes);
    }

    private static Drawing TextsChanged(Drawing drawing, IReadOnlyList<ObjectFacts> having, ObjectProperty property, string typed, Func<ObjectFacts, PlacedText, string, PlacedText> change)
    {
        var changed = having.ToDictionary(facts => ShownDrawing.TextOf(drawing, facts.Index)!.Value, facts => change(facts, facts.Text!, typed));
        foreach (var text in changed.Values)
        {
            if (!TextSummary.IsInRange(text)) throw new CommandException(CommandFailure.Usage, Wording.Get("ChProp.ValueNotPossible", property.Title, typed, $"{text.Type} {text.Content}"));
        }

        return changed.Count == 0 ? drawing : TextChange.Replaced(drawing, changed);
    }

    public static DrawingEntity OnLayer(ObjectFacts facts, string typed) =>
        facts.Entity with { Layer = CurrentLayer.IndexOf(facts.Drawing, typed.Trim()) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("ChProp.LayerNotFound", typed.Trim())) };

    public static DrawingEntity InColour(ObjectFacts facts, string typed) =>
        facts.Entity with { Colour = ColourName.ParseOfObject(typed) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("ChProp.NotAColour", typed, string.Join(", ", ColourName.Known))) };

    /// <summary>An open curve with another start or end; an arc keeps its included angle.</summary>
    public static IReadOnlyList<ChangedPart>? WithEnd(ObjectFacts facts, Point2D place, bool atStart)
    {
        var (part, before) = atStart ? (facts.FirstPart, facts.Start) : (facts.FirstPart + facts.Entity.PartCount - 1, facts.End);
        return GripStretch.Changes(facts.Drawing, [new Grip(facts.Index, part, GripKind.Vertex, before!.Value)], place);
    }

    public static IReadOnlyList<ChangedPart> Moved(ObjectFacts facts, Vector2D way) => [ChangedPart.Moved(facts.Drawing, facts.FirstPart, way)];

    /// <summary>Null if the radius is not positive.</summary>
    public static IReadOnlyList<ChangedPart>? WithRadius(ObjectFacts facts, double radius) => radius > 0.0 ? Round(facts, facts.Round!.Value with { Radius = radius }) : null;

    /// <summary>An arc in its direction from one angle to another, degrees; null if they are equal.</summary>
    public static IReadOnlyList<ChangedPart>? WithAngles(ObjectFacts facts, double start, double end)
    {
        var arc = facts.Arc!.Value;
        var turn = Angle.FromDegrees(arc.Sweep.Degrees > 0.0 ? end - start : start - end).Positive();
        return turn.Degrees > 0.0 ? Round(facts, arc with { Start = Angle.FromDegrees(start).Positive(), Sweep = arc.Sweep.Degrees > 0.0 ? turn : -turn }) : null;
    }

    private static IReadOnlyList<ChangedPart> Round(ObjectFacts facts, ArcSegment arc) => [new ChangedPart(facts.FirstPart, DrawingPart.Arc(facts.Index, arc, facts.Drawing.Parts[facts.FirstPart].C), null)];

    private static string Named(ObjectFacts facts) => $"{facts.Entity.Type.ToDxfName()} {facts.Handle}".TrimEnd();
}
