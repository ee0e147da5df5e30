using System.Reflection;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Settings;

/// <summary>Certificates and history store all settings.</summary>
public class SettingValuesTests
{
    private static readonly DrawingSettings s_other = new()
    {
        Unit = LengthUnits.FromInsUnits(1)! with { Source = "option" },
        Placement = new DrawingPlacement { Scale = 1.0 / 3.0, Mirror = MirrorAxis.Y, Rotation = Angle.FromDegrees(-0.1), Move = new Vector2D(1e-7, -0.3), Place = BlankPlace.Centre, Align = new PointPair(new(0.1, 1e-7), new(-2, 3)), To = new PointPair(default, new(1, 2.5)), AlignTolerance = 0.3, Blank = new Vector2D(1.0 / 3.0, 4), Back = MirrorAxis.X },
        Cut = CutChoice.Hatch | CutChoice.Helix,
        Layers = ["A,B", "\"Ä\n"],
        SkippedLayers = ["0", ""],
        JoinToleranceMm = 0.1 + 0.2,
        MaxErrorMm = 1e-9,
        Start = new(-1.0 / 3.0, 1e-20),
        Finish = FinishPlace.Park,
        Enter = new ContourEntry.ByHandle("A1"),
        Order = StrokeOrder.Drawn,
        KeepDuplicates = true,
        RecoverArcs = true,
        CornerToleranceMm = 0.0375,
        FitArcs = false,
        Kerf = KerfSide.Nesting,
        ToolDiameterMm = 3.175,
        Machine = MachineProfile.Default with { FeedMmPerMinute = 77.0 },
    };

    public static TheoryData<string> Names =>
        [.. typeof(DrawingSettings).GetProperties(BindingFlags.Public | BindingFlags.Instance).Where(property => !Equals(property.GetValue(s_other), property.GetValue(DrawingSettings.Default))).Select(property => property.Name).Where(name => name is not (nameof(DrawingSettings.Machine) or nameof(DrawingSettings.CuttingMachine) or nameof(DrawingSettings.MotionTolerances)))];

    /// <summary>Values that are hard to write; <see cref="SettingWalkTests"/> goes through every setting of the table.</summary>
    [Theory]
    [MemberData(nameof(Names))]
    public void Each_setting_is_kept_and_comes_back(string name)
    {
        var property = typeof(DrawingSettings).GetProperty(name)!;
        var one = new DrawingSettings();
        property.SetValue(one, property.GetValue(s_other));
        var back = SettingValues.Read(SettingValues.Of(one), MachineProfile.Default);

        Assert.NotEqual(SettingValues.Of(new DrawingSettings()), SettingValues.Of(one));
        Assert.Equal(property.GetValue(s_other), property.GetValue(back));
        Assert.Equal(SettingValues.Of(one), SettingValues.Of(back));
    }

    [Fact]
    public void A_place_to_enter_comes_back_and_what_is_missing_has_its_default()
    {
        var back = SettingValues.Read(SettingValues.Of(s_other with { Enter = new ContourEntry.ByPoint(new(1.5, -2.0)) }), s_other.Machine);

        Assert.Equal(new ContourEntry.ByPoint(new(1.5, -2.0)), back.Enter);
        Assert.Equal(77.0, back.Machine.FeedMmPerMinute);
        Assert.Equal(SettingValues.Of(new DrawingSettings()), SettingValues.Of(SettingValues.Read(new Dictionary<string, string> { ["from-a-later-version"] = "1" }, MachineProfile.Default)));
    }

    [Theory]
    [InlineData("join-tolerance", "wide")]
    [InlineData("units", "99")]
    [InlineData("start", "1,2,3")]
    [InlineData("order", "7")]
    [InlineData("layers", "A")]
    [InlineData("scale", "0")]
    [InlineData("mirror", "z")]
    [InlineData("rotate", "left")]
    [InlineData("move", "1")]
    [InlineData("align", "1,2")]
    [InlineData("to", "1,2:1,2")]
    public void A_word_that_is_no_value_is_refused(string key, string word) =>
        Assert.Throws<FormatException>(() => SettingValues.Read(new Dictionary<string, string> { [key] = word }, MachineProfile.Default));
}
