using Engraver.Core.Diagnostics;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>One setting of a job, defined once in <see cref="SettingTable"/>. The console's option, the command, the row of OPTIONS, the text that histories,
/// certificates and journals keep, docs/settings.md and the advice of findings follow from it.</summary>
/// <remarks>Plain values are a <see cref="NumberSetting"/>, <see cref="SwitchSetting"/> or <see cref="ChoiceSetting{T}"/>. A setting with structure (layers,
/// unit, entering place, kerf, machine) is a class of its own.</remarks>
public abstract class Setting(string key)
{
    /// <summary>Permanent name: files keep the value under it, and advice names the setting by it, in brackets.</summary>
    public string Key => key;

    /// <summary>Its name in lists.</summary>
    public string Name => Wording.Get("Setting." + key);

    /// <summary>One sentence with a full stop; other settings in brackets.</summary>
    public string Meaning => Wording.Get($"Setting.{key}.Meaning");

    /// <summary>Unit of the value; empty for a choice or a switch.</summary>
    public string Unit { get; init; } = "";

    /// <summary>Smallest value that the command takes, in <see cref="Unit"/>.</summary>
    public double Min { get; init; }

    /// <summary>Largest value that the command takes, in <see cref="Unit"/>; not above <see cref="Min"/> for a setting that is not a number.</summary>
    public double Max { get; init; }

    /// <summary>Only whole numbers.</summary>
    public bool Whole { get; init; }

    /// <summary>The default as tables show it: words of the resources where there are any, otherwise the value.</summary>
    public string Default => Wording.Find($"Setting.{key}.Default") ?? DefaultText;

    /// <summary>Page of OPTIONS; null for a setting that has a palette or dialog of its own.</summary>
    public SettingPage? Page { get; init; }

    /// <summary>Field of the machine profile or of <c>--json</c> that contains it; null where there is none.</summary>
    public string? JsonField { get; init; }

    /// <summary>Whether the console has an option for it.</summary>
    public bool HasOption { get; init; } = true;

    /// <summary>Option of the console; null where there is none.</summary>
    public string? Option => HasOption ? "--" + key : null;

    /// <summary>The option has no value.</summary>
    public virtual bool IsSwitch => false;

    /// <summary>The value of the option, as its help shows it; null for a switch.</summary>
    public virtual string? Argument { get; init; }

    /// <summary>The words of which the option takes one, or several; empty for any other text.</summary>
    public virtual IReadOnlyList<string> OptionWords => [];

    /// <summary>The option takes exactly one of <see cref="OptionWords"/>, and its help lists them; otherwise <see cref="WhyNotOption"/> checks the
    /// text.</summary>
    public virtual bool IsOneWord => false;

    /// <summary>The default that the help of the option states; null where the help states none.</summary>
    public virtual string? OptionDefault => null;

    /// <summary>An empty text is a value of the option: a list without entries.</summary>
    public virtual bool OptionMayBeEmpty => false;

    /// <summary>Name of the command that changes it.</summary>
    public required string Command { get; init; }

    /// <summary>The command is a class of its own, because it changes more than this value or asks for it on the canvas.</summary>
    public bool HasOwnCommand { get; init; }

    /// <summary>The prompt of a command that is not a class of its own.</summary>
    public string Instruction => Wording.Find($"Setting.{key}.Prompt") ?? Wording.Get("Settings.EnterNewValue", Command);

    /// <summary>The words that the command offers; empty for a number.</summary>
    public virtual IReadOnlyList<string> Choices => [];

    /// <summary>The command's value may be empty.</summary>
    public virtual bool MayBeEmpty => false;

    protected abstract string DefaultText { get; }

    /// <summary>Why a text is not a value of the option, in one sentence; null for a valid text.</summary>
    public abstract string? WhyNotOption(string typed);

    /// <summary>The settings with the value of the option.</summary>
    /// <param name="warn">Receives the findings of a file that the option names.</param>
    /// <exception cref="SettingException">The value is not valid.</exception>
    public abstract DrawingSettings FromOption(DrawingSettings settings, string typed, Action<string, Diagnostic> warn);

    /// <summary>Why the value cannot be used together with the other settings, with settings in brackets; null when it can.</summary>
    public virtual string? Conflict(DrawingSettings settings) => null;

    /// <summary>The value as files keep it, exact; null when there is nothing to keep: it is left to the drawing, or the machine profile contains it.</summary>
    public abstract string? ToWord(DrawingSettings settings);

    /// <summary>The settings with a value that a file kept.</summary>
    /// <exception cref="FormatException">The word is not a value.</exception>
    public abstract DrawingSettings FromWord(DrawingSettings settings, string word);

    /// <summary>The value as it is typed at its command.</summary>
    public virtual string ToInput(DrawingSettings settings) => ToWord(settings) ?? "";

    /// <summary>The settings with a value that its command has accepted.</summary>
    /// <exception cref="SettingException">The machine cannot use it.</exception>
    public virtual DrawingSettings FromInput(DrawingSettings settings, string input) => FromWord(settings, input);
}

/// <summary>A setting with a value of one type.</summary>
/// <param name="get">Its value in the settings.</param>
/// <param name="with">The settings with another value.</param>
public abstract class Setting<T>(string key, Func<DrawingSettings, T> get, Func<DrawingSettings, T, DrawingSettings> with) : Setting(key)
{
    /// <summary>The value that <see cref="DrawingSettings"/> defines.</summary>
    public T DefaultValue => get(DrawingSettings.Default);

    public T Get(DrawingSettings settings) => get(settings);

    public DrawingSettings With(DrawingSettings settings, T value) => with(settings, value);

    /// <summary>Reads the text of the option.</summary>
    public abstract ParsedInput<T> ReadOption(string typed);

    /// <summary>A value as files keep it; null for nothing to keep.</summary>
    protected abstract string? WordOf(T value);

    /// <exception cref="FormatException">The word is not a value.</exception>
    protected abstract T ParseWord(string word);

    protected override string DefaultText => WordOf(DefaultValue) ?? "";

    public sealed override string? WhyNotOption(string typed) => ReadOption(typed) is ParsedInput<T>.Invalid wrong ? wrong.Message : null;

    public override DrawingSettings FromOption(DrawingSettings settings, string typed, Action<string, Diagnostic> warn) => ReadOption(typed) switch
    {
        ParsedInput<T>.Value value => with(settings, value.Result),
        ParsedInput<T>.Invalid wrong => throw new SettingException($"{Option}: {wrong.Message}"),
        _ => throw new System.Diagnostics.UnreachableException(),
    };

    public override string? ToWord(DrawingSettings settings) => WordOf(get(settings));

    public override DrawingSettings FromWord(DrawingSettings settings, string word) => with(settings, ParseWord(word));
}

/// <summary>A page of OPTIONS; its title is the text <c>OptionPage.NAME</c>.</summary>
public enum SettingPage
{
    Drawing,
    Toolpath,
    Machine,
}
