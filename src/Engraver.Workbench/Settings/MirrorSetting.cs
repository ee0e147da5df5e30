using Engraver.Core.Drawings;

namespace Engraver.Workbench.Settings;

/// <summary>The axis about which the drawing is mirrored. Not kept where there is none.</summary>
public sealed class MirrorSetting(string key, Func<DrawingSettings, MirrorAxis> get, Func<DrawingSettings, MirrorAxis, DrawingSettings> with) : ChoiceSetting<MirrorAxis>(key, get, with)
{
    protected override string DefaultText => base.WordOf(DefaultValue)!;

    protected override string? WordOf(MirrorAxis value) => value == DefaultValue ? null : base.WordOf(value);
}
