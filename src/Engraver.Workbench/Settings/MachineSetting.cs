using Engraver.Core.Diagnostics;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Settings;

/// <summary>The machine profile of a file. It is kept as a whole beside the words of the other settings (<see cref="MachineProfileFile"/>).</summary>
public sealed class MachineSetting(string key) : Setting(key)
{
    public override string? Argument => "PROFILE.json";

    protected override string DefaultText => "";

    public override string? WhyNotOption(string typed) => null; // the file is read when the option is used

    public override DrawingSettings FromOption(DrawingSettings settings, string typed, Action<string, Diagnostic> warn)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return settings with { Machine = MachineProfileSource.Load(typed, MachineFamilies.Standard, finding => warn(typed, finding)) };
    }

    public override string? ToWord(DrawingSettings settings) => null;

    public override DrawingSettings FromWord(DrawingSettings settings, string word) => settings;
}
