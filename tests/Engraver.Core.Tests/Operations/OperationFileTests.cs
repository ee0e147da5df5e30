using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Operations;

namespace Engraver.Core.Tests.Operations;

public class OperationFileTests
{
    private static readonly Point2D[] s_none = [];

    private const string Tools = """[{"number": 3, "name": "End mill", "kind": "endmill", "diameter": 3, "flutes": 2, "maxDepth": 9, "feed": 600, "plunge": 200, "spindle": 12000}, {"number": 4, "kind": "drill", "diameter": 2, "angle": 118}]""";

    [Fact]
    public void Every_field_is_read()
    {
        var plan = Read($$"""
            { "version": "1.0", "tools": {{Tools}}, // comments and trailing commas are allowed
              "operations": [
                { "id": "o1", "name": "Outline", "on": false, "kind": "profile", "side": "outside", "select": { "layers": ["CUT"], "colours": [1, "FF0000"], "linetypes": ["DASHED"], "blocks": ["B1", "B2"], "handles": ["1A"] }, "tool": 3, "feed": 500, "plunge": 150,
                  "spindle": 9000, "startDepth": 0.5, "depth": 3, "depthPerPass": 1, "finish": 0.2, "stock": 0.1, "repeats": 2, "stopBetween": true, "direction": "climb", "order": "level",
                  "leadIn": { "shape": "arc", "radius": 2 }, "leadOut": { "shape": "line", "length": 1.5, "direction": "tangential" }, "overcut": 2.5, "ramp": { "angle": 4, "radius": 2.5 }, "start": { "rule": "top", "at": [[1, 2], [3.5, -4]], "within": 3 }, "tabs": { "count": 4, "at": [[5, 6]], "within": 2, "width": 3, "height": 1 } },
                { "id": "o5", "kind": "profile", "select": "rest", "tool": 3, "depth": 3, "start": { "rule": "corner" }, "tabs": { "spacing": 50, "width": 3, "height": 1, "shape": "sloped", "angle": 30 } },
                { "id": "o6", "kind": "profile", "select": "rest", "tool": 3, "tabs": { "count": 2, "width": 3 } },
                { "id": "o2", "kind": "pocket", "select": "rest", "tool": 3, "depth": 1, "stepover": 0.3, "zigzag": true, "angle": 30 },
                { "id": "o4", "kind": "fill", "select": "rest", "tool": 3, "depth": 0.2, "spacing": 0.5, "angle": 45, "cross": true, "inset": 0.1, "pierce": 1.5 },
                { "id": "o8", "kind": "fill", "select": "rest", "tool": 3, "spacing": 0.5, "hatches": true, "overscan": 2.5 },
                { "id": "o9", "kind": "engrave", "select": "rest", "tool": 3, "dashes": true, "power": 62.5 },
                { "id": "o7", "kind": "fill", "select": "rest", "tool": 3, "depth": 0.2, "spacing": 0.5, "pattern": "contour" },
                { "id": "o3", "kind": "drill", "select": { "layers": ["H"] }, "tool": 4, "depth": 5, "peck": 2, "maxDiameter": 4, "dwell": 0.5, }
              ] }
            """);

        var outline = plan.Operations[0];
        Assert.Equal(("o1", "Outline", false, OperationKind.Profile, ProfileSide.Outside, 3), (outline.Id, outline.Name, outline.IsOn, outline.Kind, outline.Side, outline.Tool));
        Assert.Equal(("CUT", "1 FF0000", "DASHED", "B1 B2", "1A"), (outline.Select.Layers[0], string.Join(' ', outline.Select.Colours), outline.Select.Linetypes[0], string.Join(' ', outline.Select.Blocks), outline.Select.Handles[0]));
        Assert.Equal((500.0, 150.0, 9000.0, 0.5, 3.0, 1.0, 0.2, 0.1, 2), (outline.Feed!.Value, outline.Plunge!.Value, outline.Spindle!.Value, outline.StartDepth, outline.Depth!.Value, outline.DepthPerPass!.Value, outline.Finish, outline.Stock, outline.Repeats));
        Assert.Equal((CutDirection.Climb, PassOrder.Level), (outline.Direction, outline.Order));
        Assert.Equal((new LeadMove(LeadShape.Arc, 2.0), new LeadMove(LeadShape.Line, 1.5) { Direction = LeadDirection.Tangential }, StartRule.Top, new PartTabs(3.0, 1.0) { Count = 4, Within = 2.0, At = s_none }), (outline.LeadIn!, outline.LeadOut!, outline.Start, outline.Tabs! with { At = s_none }));
        Assert.Equal([new Point2D(1.0, 2.0), new Point2D(3.5, -4.0), new Point2D(5.0, 6.0)], [.. outline.StartAt, .. outline.Tabs!.At]);
        Assert.Equal(3.0, outline.StartWithin);
        Assert.Equal((2.5, null), (outline.HelixRadius!.Value, plan.Operations[1].HelixRadius));
        Assert.Equal((2.5, 4.0, 0.0, null), (outline.Overcut, outline.RampDegrees!.Value, plan.Operations[1].Overcut, plan.Operations[1].RampDegrees));
        Assert.Equal((TabShape.Sloped, 30.0, TabShape.Square, null), (plan.Operations[1].Tabs!.Shape, plan.Operations[1].Tabs!.AngleDegrees, outline.Tabs.Shape, plan.Operations[2].Tabs!.Height));
        Assert.Equal((StartRule.Corner, 50.0, null), (plan.Operations[1].Start, plan.Operations[1].Tabs!.Spacing!.Value, plan.Operations[1].Tabs!.Count));
        Assert.Equal((true, 0.3, true, 30.0), (plan.Operations[3].Select.IsRest, plan.Operations[3].Stepover, plan.Operations[3].IsZigzag, plan.Operations[3].AngleDegrees));
        Assert.Equal((2.0, 4.0), (plan.Operations[^1].Peck!.Value, plan.Operations[^1].MaxDiameter!.Value));
        Assert.Equal((0.5, 45.0, true, 0.1), (plan.Operations[4].Spacing, plan.Operations[4].AngleDegrees, plan.Operations[4].IsCross, plan.Operations[4].Inset!.Value));
        Assert.Equal((FillPattern.Contour, FillPattern.Lines), (plan.Operations[7].Pattern, plan.Operations[4].Pattern));
        Assert.Equal((1.5, 0.5), (plan.Operations[4].PierceSeconds, plan.Operations[^1].DwellSeconds));
        Assert.Equal(["o9"], plan.Operations.Where(operation => operation.CutsDashes).Select(operation => operation.Id));
        Assert.Equal(["o1"], plan.Operations.Where(operation => operation.StopsBetween).Select(operation => operation.Id));
        Assert.Equal(["o8"], plan.Operations.Where(operation => operation.TakesHatches).Select(operation => operation.Id));
        Assert.Equal((2.5, 0.0), (plan.Operations[5].Overscan, plan.Operations[4].Overscan));
        Assert.Equal((62.5, null), (plan.Operations[6].Power!.Value, plan.Operations[4].Power));
        var tool = plan.ToolOf(outline);
        Assert.Equal(("End mill", ToolKind.Endmill, 3.0, 2, 9.0, 600.0, 200.0, 12000.0), (tool.Name, tool.Kind, tool.Diameter, tool.Flutes!.Value, tool.MaxDepth!.Value, tool.Feed!.Value, tool.Plunge!.Value, tool.Spindle!.Value));
        Assert.Equal((ToolKind.Drill, 118.0), (plan.Tools[1].Kind, plan.Tools[1].AngleDegrees!.Value));

        var again = OperationFile.Parse(plan.ToString());
        Assert.Equal(plan, again);
        Assert.Equal(plan.ToString(), again.ToString());
        Assert.Equal(plan.Operations.Select(WithoutLists), again.Operations.Select(WithoutLists));
    }

    [Theory]
    [InlineData("""{ "id": "o1", "knd": "engrave" }""", "OPR0002", "operations[0].knd", 3)]
    [InlineData("""{ "kind": "engrave", "select": "rest", "tool": 3 }""", "OPR0004", "operations[0].id", 3)]
    [InlineData("""{ "id": "", "kind": "engrave", "select": "rest", "tool": 3 }""", "OPR0003", "operations[0].id", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "dashes": true }""", "OPR0003", "operations[0].dashes", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "hatches": true }""", "OPR0003", "operations[0].hatches", 3)]
    [InlineData("""{ "id": "o1", "kind": "pocket", "select": "rest", "tool": 3, "angle": 30 }""", "OPR0003", "operations[0].angle", 3)]
    [InlineData("""{ "id": "o1", "kind": "mill", "select": "rest", "tool": 3 }""", "OPR0003", "operations[0].kind", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "all", "tool": 3 }""", "OPR0003", "operations[0].select", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": {}, "tool": 3 }""", "OPR0003", "operations[0].select", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": {"colours": [256]}, "tool": 3 }""", "OPR0003", "operations[0].select.colours", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": {"handles": ["XY"]}, "tool": 3 }""", "OPR0003", "operations[0].select.handles", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 9 }""", "OPR0003", "operations[0].tool", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "depth": 0 }""", "OPR0003", "operations[0].depth", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "depth": 1, "startDepth": 1 }""", "OPR0003", "operations[0].depth", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "depth": "lineWidth" }""", "OPR0003", "operations[0].depth", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "overscan": 2 }""", "OPR0003", "operations[0].overscan", 3)]
    [InlineData("""{ "id": "o1", "kind": "fill", "select": "rest", "tool": 3, "spacing": 1, "overscan": 0 }""", "OPR0003", "operations[0].overscan", 3)]
    [InlineData("""{ "id": "o1", "kind": "fill", "select": "rest", "tool": 3, "spacing": 1, "overscan": 2, "pattern": "contour" }""", "OPR0003", "operations[0].overscan", 3)]
    [InlineData("""{ "id": "o1", "kind": "fill", "select": "rest", "tool": 3, "spacing": 1, "overscan": 2, "depth": 1 }""", "OPR0003", "operations[0].overscan", 3)]
    [InlineData("""{ "id": "o1", "kind": "fill", "select": "rest", "tool": 3, "spacing": 1, "overscan": 2, "pierce": 1 }""", "OPR0003", "operations[0].overscan", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "power": 0 }""", "OPR0003", "operations[0].power", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "power": 100.5 }""", "OPR0003", "operations[0].power", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "power": 50, "spindle": 100 }""", "OPR0003", "operations[0].power", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "power": 50, "depth": 1 }""", "OPR0003", "operations[0].power", 3)]
    [InlineData("""{ "id": "o1", "kind": "drill", "select": "rest", "tool": 3, "power": 50 }""", "OPR0003", "operations[0].power", 3)]
    [InlineData("""{ "id": "o1", "kind": "fill", "select": "rest", "tool": 4, "depth": "lineWidth", "spacing": 1 }""", "OPR0003", "operations[0].depth", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 4, "depth": "width" }""", "OPR0003", "operations[0].depth", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "depthPerPass": 1 }""", "OPR0003", "operations[0].depthPerPass", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "depth": 5, "depthPerPass": 0.0001 }""", "OPR0003", "operations[0].depthPerPass", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "depth": 1, "side": "outside" }""", "OPR0003", "operations[0].side", 3)]
    [InlineData("""{ "id": "o1", "kind": "pocket", "select": "rest", "tool": 3, "depth": 1, "stepover": 1 }""", "OPR0003", "operations[0].stepover", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "repeats": 1.5 }""", "OPR0003", "operations[0].repeats", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "stopBetween": true }""", "OPR0003", "operations[0].stopBetween", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "on": "yes" }""", "OPR0003", "operations[0].on", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3 }, { "id": "o1", "kind": "engrave", "select": "rest", "tool": 3 }""", "OPR0003", "operations", 2)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "leadIn": {"shape": "arc", "length": 2} }""", "OPR0004", "operations[0].leadIn.radius", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "leadIn": {"shape": "arc", "radius": 2, "direction": "tangential"} }""", "OPR0003", "operations[0].leadIn.direction", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "plunge": 30 }""", "OPR0003", "operations[0].plunge", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "outputs": [""] }""", "OPR0003", "operations[0].outputs", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "ramp": {"angle": 3} }""", "OPR0003", "operations[0].ramp", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "depth": 1, "ramp": {} }""", "OPR0004", "operations[0].ramp.angle", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "depth": 1, "ramp": {"angle": 3, "radius": 1} }""", "OPR0003", "operations[0].ramp.radius", 3)]
    [InlineData("""{ "id": "o1", "kind": "drill", "select": "rest", "tool": 3, "depth": 1, "ramp": {"angle": 3} }""", "OPR0003", "operations[0].ramp", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "overcut": 0 }""", "OPR0003", "operations[0].overcut", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "depth": 2, "tabs": {"count": 1, "width": 1} }""", "OPR0004", "operations[0].tabs.height", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "tabs": {"count": 1, "width": 1, "height": 1} }""", "OPR0003", "operations[0].tabs.height", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "tabs": {"count": 1, "width": 1, "shape": "sloped"} }""", "OPR0003", "operations[0].tabs.shape", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "depth": 2, "tabs": {"count": 1, "width": 1, "height": 1, "angle": 30} }""", "OPR0003", "operations[0].tabs.angle", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "start": {"rule": "edge"} }""", "OPR0003", "operations[0].start.rule", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "start": {"at": [[1, 2, 3]]} }""", "OPR0003", "operations[0].start.at", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "start": {"at": [["1", 2]]} }""", "OPR0003", "operations[0].start.at", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "start": {"within": 3} }""", "OPR0003", "operations[0].start.within", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "depth": 1, "tabs": {"width": 1, "height": 0.5} }""", "OPR0004", "operations[0].tabs.count", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "depth": 1, "tabs": {"count": 1, "spacing": 20, "width": 1, "height": 0.5} }""", "OPR0003", "operations[0].tabs.spacing", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "depth": 1, "tabs": {"count": 0, "width": 1, "height": 0.5} }""", "OPR0003", "operations[0].tabs.count", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "depth": 1, "tabs": {"count": 2, "width": 1, "height": 1} }""", "OPR0003", "operations[0].tabs.height", 3)]
    [InlineData("""{ "id": "o1", "kind": "pocket", "select": "rest", "tool": 3, "depth": 1, "tabs": {"count": 2, "width": 1, "height": 0.5} }""", "OPR0003", "operations[0].tabs", 3)]
    [InlineData("""{ "id": "o1", "kind": "fill", "select": "rest", "tool": 3 }""", "OPR0004", "operations[0].spacing", 3)]
    [InlineData("""{ "id": "o1", "kind": "fill", "select": "rest", "tool": 3, "spacing": 1, "pattern": "contour", "angle": 5 }""", "OPR0003", "operations[0].angle", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "side": "left", "direction": "climb" }""", "OPR0003", "operations[0].direction", 3)]
    [InlineData("""{ "id": "o1", "kind": "profile", "select": "rest", "tool": 3, "leadIn": {"shape": "arc", "radius": 2, "length": 2} }""", "OPR0003", "operations[0].leadIn.length", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": {"colours": ["01"]}, "tool": 3 }""", "OPR0003", "operations[0].select.colours", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "dwell": 1 }""", "OPR0003", "operations[0].dwell", 3)]
    [InlineData("""{ "id": "o1", "kind": "drill", "select": "rest", "tool": 3, "depth": 1, "pierce": 1 }""", "OPR0003", "operations[0].pierce", 3)]
    [InlineData("""{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3, "pierce": 31 }""", "OPR0003", "operations[0].pierce", 3)]
    [InlineData("[1]", "OPR0003", "operations[0]", 2)]
    [InlineData("", "OPR0003", "operations", 2)]
    public void What_is_wrong_is_named_with_its_line(string operations, string id, string field, long line)
    {
        var read = OperationFile.Read($"{{ \"version\": \"1.0\", \"tools\": {Tools},\n\"operations\": [\n{operations}\n]}}", _ => (null, ""));

        Assert.Null(read.Plan);
        Assert.Contains(read.Diagnostics, finding => finding.Id == id && finding.Facts[0] == field && finding.Source.Line == line);
    }

    [Fact]
    public void A_text_that_is_not_JSON_has_its_line()
    {
        var finding = Assert.Single(OperationFile.Read("{ \"version\": \"1.0\",\n]", _ => (null, "")).Diagnostics);

        Assert.Equal(("OPR0001", 2L), (finding.Id, finding.Source.Line));
    }

    [Fact]
    public void A_text_that_is_not_Unicode_is_an_error() =>
        Assert.Equal("OPR0001", Assert.Single(OperationFile.Read("{ \"version\": \"1.0\", \"tools\": [], \"operations\": [{ \"id\": \"\\ud800\" }] }", _ => (null, "")).Diagnostics).Id);

    [Fact]
    public void The_tools_of_a_library_have_the_feeds_of_the_material()
    {
        const string library = """{ "tools": [{"number": 3, "diameter": 3, "feed": 600}], "materials": [{"name": "oak", "feeds": [{"tool": 3, "feed": 450, "plunge": 120}]}, {"name": "pine", "feeds": []}] }""";
        string File(string material) => $$"""{ "version": "1.0", "tools": "shop.tools.json", {{material}} "operations": [{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3 }] }""";
        CuttingTool Tool(string material) => OperationFile.Read(File(material), name => name == "shop.tools.json" ? (library, "") : (null, "none")).Plan!.Tools[0];

        Assert.Equal((450.0, 120.0), (Tool("\"material\": \"oak\",").Feed!.Value, Tool("\"material\": \"oak\",").Plunge!.Value));
        Assert.Equal(((double?)600.0, null), (Tool("\"material\": \"pine\",").Feed, Tool("").Plunge));
        var unknown = Assert.Single(OperationFile.Read(File("\"material\": \"steel\","), _ => (library, "")).Diagnostics);
        Assert.Equal(("OPR0003", "material", "steel", "oak, pine"), (unknown.Id, unknown.Facts[0], unknown.Facts[1], unknown.Facts[2]));
        var elsewhere = Assert.Single(OperationFile.Read(File("\"materials\": [],"), _ => (library, "")).Diagnostics);
        Assert.Equal(("OPR0003", "materials"), (elsewhere.Id, elsewhere.Facts[0]));
    }

    [Fact]
    public void A_library_that_cannot_be_read_or_is_wrong_is_an_error_of_the_file()
    {
        const string file = """{ "version": "1.0", "tools": "shop.tools.json", "operations": [{ "id": "o1", "kind": "engrave", "select": "rest", "tool": 3 }] }""";

        Assert.Contains(OperationFile.Read(file, _ => (null, "the file does not exist")).Diagnostics, finding => finding.Id == "OPR0003" && finding.Facts[2] == "the file does not exist");
        var wrong = OperationFile.Read(file, _ => ("{ \"tools\": [\n{\"number\": 3, \"diametre\": 3}] }", ""));
        Assert.Null(wrong.Plan);
        Assert.Contains(wrong.Diagnostics, finding => finding.Id == "OPR0001" && finding.Facts[0].StartsWith("shop.tools.json(2)", StringComparison.Ordinal) && finding.Facts[0].Contains("diametre", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData(3.0, 0.0, null, 0.0, 1, "3")]
    [InlineData(3.0, 0.0, 1.0, 0.0, 1, "1 2 3")]
    [InlineData(3.0, 0.0, 2.0, 0.0, 1, "1.5 3")]
    [InlineData(3.0, 1.0, 1.0, 0.0, 1, "2 3")]
    [InlineData(3.0, 0.0, 1.0, 0.2, 1, "0.933333 1.866667 2.8 3")]
    [InlineData(3.0, 0.0, null, 0.2, 2, "2.8 3 3")]
    [InlineData(0.3, 0.0, 0.1, 0.0, 1, "0.1 0.2 0.3")]
    public void The_passes_divide_the_depth(double depth, double start, double? step, double finish, int repeats, string expected)
    {
        var operation = new Operation { Id = "o", Kind = OperationKind.Engrave, Select = OperationSelection.Rest, Tool = 1, Depth = depth, StartDepth = start, DepthPerPass = step, Finish = finish, Repeats = repeats };

        Assert.Equal(expected, string.Join(' ', operation.PassDepths().Select(one => Math.Round(one, 6).ToString(System.Globalization.CultureInfo.InvariantCulture))));
        Assert.Equal(depth, operation.PassDepths()[^1]);
    }

    private static Operation WithoutLists(Operation operation) => operation with { Select = OperationSelection.Rest, StartAt = s_none, Tabs = operation.Tabs is { } tabs ? tabs with { At = s_none } : null };

    private static OperationPlan Read(string json)
    {
        var read = OperationFile.Read(json, _ => (null, ""));
        Assert.True(read.Plan is not null, string.Join('\n', read.Diagnostics.Select(finding => finding.Message)));
        return read.Plan;
    }
}
