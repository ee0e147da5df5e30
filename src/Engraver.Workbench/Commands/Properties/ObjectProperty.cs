using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Objects;

namespace Engraver.Workbench.Commands.Properties;

/// <summary>What can be said of an object, and for some of it how it is changed.</summary>
/// <param name="Name">As CHPROP takes it; its capital letters are the short form.</param>
/// <param name="IsGeneral">Every object has it; otherwise it belongs to the geometry.</param>
public sealed record ObjectProperty(string Name, bool IsGeneral)
{
    /// <summary>As people read it.</summary>
    public string Title => Wording.Get("Property." + Name);

    public bool IsEditable => Change is not null || Entity is not null || Closed is not null;

    /// <summary>The values that it can have in a drawing, where these are known; empty for any.</summary>
    public Func<Drawing, IReadOnlyList<string>> Choices { get; init; } = _ => [];

    /// <summary>The value as it is shown; null when the object has no such property.</summary>
    internal Func<ObjectFacts, Figures, string?> Read { get; init; } = (_, _) => null;

    /// <summary>The parts of an object with a new value; null when nothing would be left of it. Only for objects that have the property.</summary>
    internal Func<ObjectFacts, double, IReadOnlyList<ChangedPart>?>? Change { get; init; }

    /// <summary>The entity with a new value; throws what is wrong with the text.</summary>
    internal Func<ObjectFacts, string, DrawingEntity>? Entity { get; init; }

    /// <summary>Whether the object closes with a new value; throws what is wrong with the text.</summary>
    internal Func<string, bool>? Closed { get; init; }

    /// <summary>False for an object that shows it but cannot be changed.</summary>
    internal Func<ObjectFacts, bool> Allows { get; init; } = _ => true;

    /// <summary>A length that is shown and not changed.</summary>
    internal static ObjectProperty Length(string name, Func<ObjectFacts, double?> read) => new(name, false) { Read = (facts, figures) => read(facts) is { } value ? figures.Length(value) : null };

    /// <summary>An angle, degrees from 0 up to 360.</summary>
    internal static ObjectProperty Angle(string name, Func<ObjectFacts, Angle?> read) => new(name, false) { Read = (facts, figures) => read(facts) is { } value ? figures.Degrees(value) : null };
}
