using Engraver.App.Binding;

namespace Engraver.App.Properties;

/// <summary>A property and its value; if it can be edited, Enter accepts the typed value.</summary>
/// <param name="name">The displayed name.</param>
/// <param name="value">The present value.</param>
/// <param name="change">Sets a value and returns whether it was changed; null if it cannot be edited.</param>
public sealed class PropertyLine(string name, string value, Func<string, Task<bool>>? change = null) : ObservableObject, IEquatable<PropertyLine>
{
    private string _typed = value;

    /// <summary>Enter also moves the focus, which would accept the field a second time.</summary>
    private bool _isBeingChanged;

    public string Name => name;

    public string Value { get; } = value;

    public bool IsHeader { get; private init; }

    /// <summary>The possible values, where they are known: layers.</summary>
    public IReadOnlyList<string> Choices { get; init; } = [];

    public bool HasChoices => Choices.Count > 0;

    public bool IsTyped => change is not null && !HasChoices;

    public bool IsShown => change is null && !IsHeader;

    /// <summary>The text of the field.</summary>
    public string Typed
    {
        get => _typed;
        set => SetProperty(ref _typed, value ?? "");
    }

    /// <summary>The selected choice; null for values that vary.</summary>
    public string? Chosen
    {
        get => Choices.FirstOrDefault(choice => choice == Value);
        set
        {
            if (value is { } choice && choice != Value) _ = ChangeAsync(choice);
        }
    }

    /// <summary>The heading of a section.</summary>
    public static PropertyLine Header(string title) => new(title, "", null) { IsHeader = true };

    /// <summary>Enter: accepts the text of the field as the new value.</summary>
    public void Accept()
    {
        if (Typed != Value) _ = ChangeAsync(Typed.Trim());
    }

    /// <summary>Esc: the field shows the value again.</summary>
    public void Revert() => Typed = Value;

    /// <summary>A refusal is reported in the history, and the field shows the value again.</summary>
    private async Task ChangeAsync(string to)
    {
        if (change is null || _isBeingChanged) return;
        _isBeingChanged = true;
        if (!await change(to))
        {
            Revert();
            OnPropertyChanged(nameof(Chosen));
        }

        _isBeingChanged = false;
    }

    /// <summary>Read-only lines are equal if their texts are.</summary>
    public bool Equals(PropertyLine? other) => ReferenceEquals(this, other) || (other is { IsHeader: var head } && head == IsHeader && IsShown && other.IsShown && (other.Name, other.Value) == (Name, Value));

    public override bool Equals(object? obj) => Equals(obj as PropertyLine);

    public override int GetHashCode() => HashCode.Combine(Name, Value);

    /// <summary>For a screen reader.</summary>
    public override string ToString() => $"{name} {Value}".TrimEnd();
}
