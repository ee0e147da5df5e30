namespace Engraver.Workbench.Settings;

/// <summary>One setting of a job, described once: the console's options, the commands, the advice of findings and docs/settings.md take name, unit, range,
/// default and help from here.</summary>
/// <param name="Key">Permanent name; advice names a setting by it, in brackets.</param>
public sealed record SettingDescription(string Key)
{
    /// <summary>Its name in lists.</summary>
    public string Name => Wording.Get("Setting." + Key);

    /// <summary>One sentence with a full stop; other settings in brackets.</summary>
    public string Meaning => Wording.Get($"Setting.{Key}.Meaning");

    /// <summary>Unit of the value; empty for a choice or a switch.</summary>
    public string Unit { get; init; } = "";

    /// <summary>Least value that the command takes, in <see cref="Unit"/>.</summary>
    public double Least { get; init; }

    /// <summary>Largest value that the command takes, in <see cref="Unit"/>.</summary>
    public double Most { get; init; }

    /// <summary>Only whole numbers.</summary>
    public bool Whole { get; init; }

    /// <summary>The value before the operator chooses one; a text of the resources where it is said in words.</summary>
    public string Default
    {
        get => Wording.Find($"Setting.{Key}.Default") ?? field;
        init;
    } = "";

    /// <summary>Option of the console; null where there is none.</summary>
    public string? Flag { get; init; }

    /// <summary>The value behind the option, as its help shows it; null for a switch.</summary>
    public string? Argument { get; init; }

    /// <summary>What is typed at the command line of the desktop, with its value where one choice is meant; null where there is nothing to type.</summary>
    public string? Command { get; init; }

    /// <summary>Field of the machine profile or of <c>--json</c> that holds it; null where there is none.</summary>
    public string? JsonField { get; init; }
}
