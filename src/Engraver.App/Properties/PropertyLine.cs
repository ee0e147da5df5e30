using Engraver.App.Binding;

namespace Engraver.App.Properties;

/// <summary>A property and its value; where it can be edited, what is typed is taken on Enter.</summary>
/// <param name="name">As people read it.</param>
/// <param name="value">As it is.</param>
/// <param name="change">Takes another value and tells whether it was changed; null where it cannot be edited.</param>
public sealed class PropertyLine(string name, string value, Func<string, Task<bool>>? change = null) : Observable, IEquatable<PropertyLine>
{
    private string _typed = value;

    /// <summary>Enter takes the focus away, which takes a field too: once is enough.</summary>
    private bool _isBeingChanged;

    public string Name => name;

    public string Value { get; } = value;

    public bool IsHead { get; private init; }

    /// <summary>The values that it can have, where these are known: layers.</summary>
    public IReadOnlyList<string> Choices { get; init; } = [];

    public bool HasChoices => Choices.Count > 0;

    public bool IsTyped => change is not null && !HasChoices;

    public bool IsShown => change is null && !IsHead;

    /// <summary>What stands in the field.</summary>
    public string Typed
    {
        get => _typed;
        set => Set(ref _typed, value ?? "");
    }

    /// <summary>The choice that is made; null for values that vary.</summary>
    public string? Chosen
    {
        get => Choices.FirstOrDefault(choice => choice == Value);
        set
        {
            if (value is { } choice && choice != Value) _ = ChangeAsync(choice);
        }
    }

    /// <summary>The beginning of a section.</summary>
    public static PropertyLine Head(string title) => new(title, "", null) { IsHead = true };

    /// <summary>Enter: what stands in the field is the new value.</summary>
    public void Take()
    {
        if (Typed != Value) _ = ChangeAsync(Typed.Trim());
    }

    /// <summary>Esc: the field shows the value again.</summary>
    public void GiveUp() => Typed = Value;

    /// <summary>What is refused is told in the history, and the field shows the value again.</summary>
    private async Task ChangeAsync(string to)
    {
        if (change is null || _isBeingChanged) return;
        _isBeingChanged = true;
        if (!await change(to))
        {
            GiveUp();
            Tell(nameof(Chosen));
        }

        _isBeingChanged = false;
    }

    /// <summary>Lines that cannot be edited are the same when they read the same.</summary>
    public bool Equals(PropertyLine? other) => ReferenceEquals(this, other) || (other is { IsHead: var head } && head == IsHead && IsShown && other.IsShown && (other.Name, other.Value) == (Name, Value));

    public override bool Equals(object? obj) => Equals(obj as PropertyLine);

    public override int GetHashCode() => HashCode.Combine(Name, Value);

    /// <summary>For a reader of the screen.</summary>
    public override string ToString() => $"{name} {Value}".TrimEnd();
}
