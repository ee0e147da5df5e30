using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Documents;

/// <summary>A drawing gets its unit when it is opened or created. CNCUNITS is for the next OPEN and does not change the drawing that is open.</summary>
public class DrawingScaleTests
{
    private const string Inches = "1";
    private const string Millimetres = "4";
    private const string TheDrawings = "0";

    [Fact]
    public async Task The_setting_is_for_the_next_open()
    {
        await using var talk = await InchDrawingAsync();
        await talk.TypeAsync("CNCUNITS", Millimetres);
        Assert.Equal(25.4, MillimetresPerUnit(talk));
        await talk.TypeAsync("OPEN", "inch.dxf");
        Assert.Equal(1.0, MillimetresPerUnit(talk));
        await talk.TypeAsync("CNCUNITS", TheDrawings);
        Assert.Equal(1.0, MillimetresPerUnit(talk));
        await talk.TypeAsync("OPEN", "inch.dxf");
        Assert.Equal(25.4, MillimetresPerUnit(talk));
    }

    [Fact]
    public async Task Undo_and_redo_of_open_bring_each_drawing_back_with_its_own_unit()
    {
        await using var talk = await InchDrawingAsync();
        await talk.TypeAsync("CNCUNITS", Millimetres, "OPEN", "inch.dxf");
        Assert.Equal(1.0, MillimetresPerUnit(talk));
        await talk.TypeAsync("U");
        Assert.Equal(25.4, MillimetresPerUnit(talk));
        await talk.TypeAsync("REDO");
        Assert.Equal(1.0, MillimetresPerUnit(talk));
    }

    [Fact]
    public async Task A_drawing_is_saved_in_its_own_unit()
    {
        await using var talk = await InchDrawingAsync();
        await talk.TypeAsync("CNCUNITS", Millimetres, "SAVEAS", "saved.dxf", "CNCUNITS", TheDrawings, "OPEN", "saved.dxf");
        Assert.Equal(25.4, MillimetresPerUnit(talk));
        Assert.Equal(2.0, talk.State.Drawing!.Parts[0].D);
    }

    [Fact]
    public async Task A_new_drawing_takes_the_setting_and_keeps_it()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("CNCUNITS", Inches, "NEW", "CNCUNITS", Millimetres, "LINE", "0,0", "1,0", "");
        Assert.Equal(25.4, MillimetresPerUnit(talk));
        Assert.Equal(25.4, JobPreparation.Analyse(talk.State.Drawing!, talk.State.Settings).ToSegments().Single().Length);
        await talk.TypeAsync("NEW");
        Assert.Equal(1.0, MillimetresPerUnit(talk));
    }

    /// <summary>The circle of radius 2 in; the tool of 25.4 mm runs outside.</summary>
    [Fact]
    public async Task KERF_shows_the_path_in_the_unit_of_the_drawing()
    {
        await using var talk = await InchDrawingAsync();
        await talk.TypeAsync("CNCUNITS", Millimetres, "KERF", "Outside", "Preview", "25.4");
        Assert.Contains(talk.Session.Prompt.Preview!(default), segment => segment.Kind == SegmentKind.Circle && Math.Abs(segment.Arc.Radius - 2.5) < 1e-9);
    }

    [Fact]
    public async Task POCKET_shows_and_takes_its_passes_in_the_unit_of_the_drawing()
    {
        await using var talk = await InchDrawingAsync();
        await talk.TypeAsync("CNCUNITS", Millimetres, "POCKET", "ALL", "", "12.7", "");
        Assert.Equal(1.75, talk.Session.Prompt.Preview!(default).Max(segment => segment.Start.DistanceTo(Point2D.Origin)), 9);
    }

    /// <summary>What is recorded of a job opens its drawing again as it was.</summary>
    [Fact]
    public async Task Certificates_and_records_name_the_unit_with_which_the_drawing_was_opened()
    {
        await using var talk = await InchDrawingAsync();
        await talk.TypeAsync("CNCUNITS", Millimetres);
        Assert.DoesNotContain(SettingTable.Units.Key, RecordOf(talk).Keys);

        await talk.TypeAsync("OPEN", "inch.dxf", "CNCUNITS", TheDrawings);
        Assert.Equal(Millimetres, RecordOf(talk)[SettingTable.Units.Key]);
    }

    [Fact]
    public async Task Certificates_and_records_name_the_construction_with_which_the_drawing_was_opened()
    {
        const string Solids = "16";
        await using var talk = await InchDrawingAsync();
        await talk.TypeAsync("CNCCUT", Solids);
        Assert.Equal("0", RecordOf(talk)[SettingTable.Cut.Key]);

        await talk.TypeAsync("OPEN", "inch.dxf", "CNCCUT", "0");
        Assert.Equal(Solids, RecordOf(talk)[SettingTable.Cut.Key]);
        await talk.TypeAsync("OPEN", "inch.dxf");
        Assert.Equal("0", RecordOf(talk)[SettingTable.Cut.Key]);
    }

    /// <summary>What is recorded of a job of the drawing that is open.</summary>
    private static IReadOnlyDictionary<string, string> RecordOf(CommandTestSession talk) =>
        SettingValues.Of(JobPreparation.Prepare(talk.State.Drawing!, talk.State.Settings, Engraver.Core.Machines.MotionStyle.Continuous).Recorded);

    private static double MillimetresPerUnit(CommandTestSession talk) => talk.State.Scale.MillimetresPerUnit;

    /// <summary>A circle of radius 2 about the origin, and a file of it that states inches.</summary>
    private static async Task<CommandTestSession> InchDrawingAsync()
    {
        var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder { Unit = LengthUnits.FromInsUnits(1)! }.Circle(0.0, 0.0, 2.0).Build() });
        await talk.TypeAsync("SAVEAS", "inch.dxf", "OPEN", "inch.dxf");
        return talk;
    }
}
