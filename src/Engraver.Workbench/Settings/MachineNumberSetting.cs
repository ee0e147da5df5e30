using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Settings;

/// <summary>A number of the machine profile that a command can change. The profile keeps it.</summary>
public class MachineNumberSetting(string key, Func<MachineProfile, double> get, Func<MachineProfile, double, MachineProfile> with)
    : NumberSetting(key, settings => get(settings.Machine), (settings, value) => settings with { Machine = with(settings.Machine, value) })
{
    public override string? OptionDefault => null;

    public override string? ToWord(DrawingSettings settings) => null;

    public override DrawingSettings FromWord(DrawingSettings settings, string word) => settings;

    /// <exception cref="SettingException">The machine cannot work with this value.</exception>
    public override DrawingSettings FromInput(DrawingSettings settings, string input)
    {
        var changed = base.FromInput(settings, input);
        return MachineProfileValidation.Check(changed.Machine, MachineFamilies.DriverOf(changed.Machine).Limits) is [var wrong, ..] ? throw new SettingException(wrong.Message) : changed;
    }
}

/// <summary>The feed: it overrides that of the machine profile, so its option is applied after the profile's.</summary>
public sealed class FeedSetting(string key, Func<MachineProfile, double> get, Func<MachineProfile, double, MachineProfile> with) : MachineNumberSetting(key, get, with)
{
    public override DrawingSettings FromOption(DrawingSettings settings, string typed, Action<string, Diagnostic> warn)
    {
        ArgumentNullException.ThrowIfNull(settings);
        var (changed, limits) = (base.FromOption(settings, typed, warn), MachineFamilies.DriverOf(settings.Machine).Limits);
        var feed = Get(changed);
        return MachineProfileValidation.IsFeed(feed, settings.Machine, limits) ? changed : throw new SettingException(SettingWording.OnConsole(Wording.Get("Setting.feed.OutOfRange", TypedNumber.Exact(feed), MachineProfileValidation.FeedRange(settings.Machine, limits))));
    }
}
