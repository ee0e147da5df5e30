using Engraver.App.Binding;
using Engraver.Workbench.Commands.Settings;

namespace Engraver.App.Options;

/// <summary>A setting on the sheet, with its edited value.</summary>
public sealed class OptionRow(OptionEntry entry) : ObservableObject
{
    private const string On = "1";
    private const string Off = "0";
    private string _typed = entry.Value;
    private string _error = "";

    public OptionEntry Entry => entry;

    /// <summary>The name with its unit.</summary>
    public string Title => entry.Unit.Length > 0 ? Texts.Text.Get("Options.WithUnit", entry.Name, entry.Unit) : entry.Name;

    /// <summary>Its meaning, its possible values, and its default.</summary>
    public string Meaning => entry.Default.Length > 0 ? Texts.Text.Get("Options.MeaningWithDefault", entry.Meaning, entry.Command, entry.DisplayDefault) : Texts.Text.Get("Options.Meaning", entry.Meaning, entry.Command);

    public bool IsNumber => entry.Choices.Count == 0 && !entry.IsSwitch;

    public bool IsChoice => entry.Choices.Count > 0;

    /// <summary>The possible words.</summary>
    public IReadOnlyList<OptionChoice> Choices { get; } = entry.DisplayChoices;

    /// <summary>The selected word; null for a number.</summary>
    public OptionChoice? Choice
    {
        get => Choices.FirstOrDefault(choice => choice.Value == _typed);
        set
        {
            if (value is not null) Typed = value.Value;
        }
    }

    public string Typed
    {
        get => _typed;
        set
        {
            if (!SetProperty(ref _typed, (value ?? "").Trim())) return;
            Error = entry.RefusalOf(_typed) ?? "";
            OnPropertyChanged(nameof(IsOn));
            OnPropertyChanged(nameof(Choice));
        }
    }

    /// <summary>The value of a switch.</summary>
    public bool IsOn
    {
        get => _typed == On;
        set => Typed = value ? On : Off;
    }

    /// <summary>The edited value differs from the current one.</summary>
    public bool IsChanged => _typed != entry.Value;

    /// <summary>The error in the value, in a sentence; empty if the value is valid.</summary>
    public string Error
    {
        get => _error;
        set
        {
            SetProperty(ref _error, value);
            OnPropertyChanged(nameof(HasError));
        }
    }

    public bool HasError => _error.Length > 0;
}
