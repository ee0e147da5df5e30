using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Settings;

/// <summary>Width and height of the blank, mm; both above 0. It checks all settings that place a drawing on its blank.</summary>
public sealed class BlankSetting(string key, Func<DrawingSettings, Vector2D> get, Func<DrawingSettings, Vector2D, DrawingSettings> with) : MoveSetting(key, get, with)
{
    public override string? Argument => "W,H";

    protected override string DefaultText => "";

    public override ParsedInput<Vector2D> ReadOption(string typed) =>
        base.ReadOption(typed) is ParsedInput<Vector2D>.Value { Result: { X: > 0.0, Y: > 0.0 } } size ? size : new ParsedInput<Vector2D>.Invalid(Wording.Get("Setting.blank.Invalid", typed));

    public override string? Conflict(DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return settings.Placement switch
        {
            { Back: not MirrorAxis.None, Blank: { X: 0.0 } } => Wording.Get("Setting.blank.NeededBack"),
            { Place: BlankPlace.Centre, Blank: { X: 0.0 } } => Wording.Get("Setting.blank.NeededCentre"),
            { Align: null, To: not null } or { Align: not null, To: null } => Wording.Get("Setting.align.NeedsBoth"),
            { Align: not null, Place: not BlankPlace.None } => Wording.Get("Setting.align.NotWithPlace"),
            { AlignError: var error, AlignTolerance: var tolerance } when error > tolerance => Wording.Get("Setting.align.Differs", error, tolerance),
            _ => null,
        };
    }
}
