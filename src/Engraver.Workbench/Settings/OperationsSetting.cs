using Engraver.Core.Diagnostics;
using Engraver.Core.Kerf;
using Engraver.Core.Operations;

namespace Engraver.Workbench.Settings;

/// <summary>The operations of a file. Files keep them as their text, tools included.</summary>
public sealed class OperationsSetting(string key) : Setting(key)
{
    public override string? Argument => "FILE.json";

    protected override string DefaultText => "";

    public override string? WhyNotOption(string typed) => null; // the file is read when the option is used

    public override DrawingSettings FromOption(DrawingSettings settings, string typed, Action<string, Diagnostic> warn)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return settings with { Operations = OperationsSource.Load(typed) };
    }

    public override string? Conflict(DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        if (settings.Operations is null) return null;
        if (settings.Kerf != KerfSide.Off) return Wording.Get("Setting.operations.NotWithKerf");
        return settings.Enter is null ? null : Wording.Get("Setting.operations.NotWithEnter");
    }

    public override string? ToWord(DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return settings.Operations?.ToString();
    }

    public override DrawingSettings FromWord(DrawingSettings settings, string word)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return settings with { Operations = OperationFile.Parse(word) };
    }
}
