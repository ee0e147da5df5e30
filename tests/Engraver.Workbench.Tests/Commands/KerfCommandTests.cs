using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

public class KerfCommandTests
{
    [Fact]
    public async Task Side_and_diameter_are_kept_undone_and_switched_off()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("KERF", "N", "3.5");
        Assert.Equal((KerfSide.Nesting, 3.5), (talk.State.Settings.Kerf, talk.State.Settings.ToolDiameterMm));
        await talk.TypeAsync("KERF", "OFF");
        Assert.Equal((KerfSide.Off, 3.5), (talk.State.Settings.Kerf, talk.State.Settings.ToolDiameterMm));
        await talk.TypeAsync("U");
        Assert.Equal(KerfSide.Nesting, talk.State.Settings.Kerf);
        await talk.TypeAsync("KERF", "I", "");
        Assert.Equal((KerfSide.Inside, 3.5), (talk.State.Settings.Kerf, talk.State.Settings.ToolDiameterMm));
        Assert.IsNotType<InputResult.Failed>(await talk.TypeAsync("KERF", "L", "2"));
        Assert.Equal((KerfSide.Left, 2.0), (talk.State.Settings.Kerf, talk.State.Settings.ToolDiameterMm));
    }

    /// <summary>Of a circle of radius 3 about 20,5, whose hole side is the inside.</summary>
    [Fact]
    public async Task The_path_of_the_tool_is_seen_before_it_is_taken()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("KERF", "Outside");
        Assert.Null(talk.Session.Prompt.Preview); // no diameter yet
        await talk.TypeAsync("Preview", "2");
        Assert.Contains(talk.Session.Prompt.Preview!(default), segment => segment.Kind == SegmentKind.Circle && Math.Abs(segment.Arc.Radius - 4.0) < 1e-9);
        await talk.TypeAsync("P", "1");
        Assert.Contains(talk.Session.Prompt.Preview!(default), segment => segment.Kind == SegmentKind.Circle && Math.Abs(segment.Arc.Radius - 3.5) < 1e-9);
        Assert.Equal(KerfSide.Off, talk.State.Settings.Kerf);
        await talk.TypeAsync("");
        Assert.Equal((KerfSide.Outside, 1.0), (talk.State.Settings.Kerf, talk.State.Settings.ToolDiameterMm));
        await talk.TypeAsync("KERF", "Inside");
        Assert.Contains(talk.Session.Prompt.Preview!(default), segment => segment.Kind == SegmentKind.Circle && Math.Abs(segment.Arc.Radius - 2.5) < 1e-9);
    }

    [Fact]
    public async Task AUTOSEQUENCE_TABLE_and_EXPORT_show_the_compensated_path_and_Drawn_what_is_drawn()
    {
        await using var talk = new CommandTestSession();
        talk.Session.Document.Commit("OPEN", new DocumentState { Drawing = new DrawingBuilder().Circle(20, 5, 3).Build() });
        await talk.TypeAsync("KERF", "Outside", "2", "AUTOSEQUENCE", "TABLE", "S", "Csv", "cut.csv", "TABLE", "D", "Csv", "drawn.csv", "EXPORT", "out.csv", "EXPORT", "cl.dxf");
        var (cut, drawn) = (await File.ReadAllTextAsync(talk.PathOf("cut.csv")), await File.ReadAllTextAsync(talk.PathOf("drawn.csv")));

        Assert.Contains("25.13", talk.Said, StringComparison.Ordinal); // 8 pi
        Assert.Equal((4.0, 3.0), (RadiusIn(cut), RadiusIn(drawn)));
        Assert.Equal(cut, await File.ReadAllTextAsync(talk.PathOf("out.csv")));
        Assert.Matches(@"\n40\r?\n4(\.0)?\r?\n", await File.ReadAllTextAsync(talk.PathOf("cl.dxf")));
    }

    private static double RadiusIn(string csv)
    {
        var row = csv.Split('\n')[1].Trim().Split(',');
        return double.Parse(row[(int)EntitySlot.Radius], System.Globalization.CultureInfo.InvariantCulture);
    }
}
