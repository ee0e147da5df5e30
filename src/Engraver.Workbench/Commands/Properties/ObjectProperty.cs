using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Objects;

namespace Engraver.Workbench.Commands.Properties;

/// <summary>A property of objects: how it is read and, if editable, changed.</summary>
/// <param name="Name">The name at CHPROP; its capital letters are the short form.</param>
/// <param name="IsGeneral">True if every object has it; otherwise it depends on the geometry.</param>
public sealed record ObjectProperty(string Name, bool IsGeneral)
{
    /// <summary>Displayed name.</summary>
    public string Title => Wording.Get("Property." + Name);

    public bool IsEditable => Change is not null || Entity is not null || Closed is not null || OfText is not null;

    /// <summary>The possible values in a drawing; empty for any value.</summary>
    public Func<Drawing, IReadOnlyList<string>> Choices { get; init; } = _ => [];

    /// <summary>The displayed value; null if the object lacks the property.</summary>
    internal Func<ObjectFacts, DisplayPrecision, string?> Read { get; init; } = (_, _) => null;

    /// <summary>The parts of an object with a new value; null if the object would vanish. Only for objects that have the property.</summary>
    internal Func<ObjectFacts, double, IReadOnlyList<ChangedPart>?>? Change { get; init; }

    /// <summary>The entity with a new value; throws if the text is invalid.</summary>
    internal Func<ObjectFacts, string, DrawingEntity>? Entity { get; init; }

    /// <summary>The text with a new value; throws if the typed value is invalid. Only for texts that have the property.</summary>
    internal Func<ObjectFacts, PlacedText, string, PlacedText>? OfText { get; init; }

    /// <summary>Whether the new value closes the object; throws if the text is invalid.</summary>
    internal Func<string, bool>? Closed { get; init; }

    /// <summary>False for an object whose value is read-only.</summary>
    internal Func<ObjectFacts, bool> Allows { get; init; } = _ => true;

    /// <summary>A read-only length.</summary>
    internal static ObjectProperty Length(string name, Func<ObjectFacts, double?> read) => new(name, false) { Read = (facts, figures) => read(facts) is { } value ? figures.FormatLength(value) : null };

    /// <summary>A read-only angle, degrees from 0 up to 360.</summary>
    internal static ObjectProperty Angle(string name, Func<ObjectFacts, Angle?> read) => new(name, false) { Read = (facts, figures) => read(facts) is { } value ? figures.FormatDegrees(value) : null };
}
