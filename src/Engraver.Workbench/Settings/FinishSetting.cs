using Engraver.Core.Machines.Origins;

namespace Engraver.Workbench.Settings;

/// <summary>Where the machine goes after the last stroke. Its command checks that the machine profile has a park position.</summary>
public sealed class FinishSetting(string key, Func<DrawingSettings, FinishPlace> get, Func<DrawingSettings, FinishPlace, DrawingSettings> with) : ChoiceSetting<FinishPlace>(key, get, with)
{
    /// <summary>The help shows the words in the order of their meaning.</summary>
    public override bool IsOneWord => false;

    public override string? OptionDefault => null;
}
