using System.Text.Json.Nodes;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>Programs of random plates that were written with other operations than stated: a wrong side, radius or depth, a missing pass, a tab gone.</summary>
public class OperationFaultTests
{
    /// <summary>Faults by name; each changes the operations, and returns false where a plate has nothing to change.</summary>
    private static readonly (string Name, Func<JsonObject, Random, bool> Apply)[] s_faults =
    [
        ("side", (plan, _) => Set(plan, "outline", "side", (string?)Of(plan, "outline")["side"] == "outside" ? "inside" : "outside")),
        ("radius", (plan, random) => Change((JsonObject)plan["tools"]![0]!, "diameter", random)),
        ("depth", (plan, random) => Change(Of(plan, "outline"), "depth", random)),
        ("pocket depth", (plan, random) => Change(Of(plan, "pocket"), "depth", random)),
        ("hole depth", (plan, random) => Change(Of(plan, "holes"), "depth", random)),
        ("depth of a mark", (plan, random) => Change(Of(plan, "marks"), "depth", random)),
        ("missing pass", (plan, _) => Set(plan, "outline", "depthPerPass", 1000.0)),
        ("operation gone", (plan, random) => Set(plan, ((string[])["outline", "pocket", "holes", "marks"])[random.Next(4)], "on", false)),
        ("tabs gone", (plan, _) => Of(plan, "outline").Remove("tabs")),
        ("tab height", (plan, random) => Change((JsonObject)Of(plan, "outline")["tabs"]!, "height", random)),
        ("tab width", (plan, random) => Change((JsonObject)Of(plan, "outline")["tabs"]!, "width", random)),
        ("stock", (plan, _) => Set(plan, "outline", "stock", 0.15)),
        ("repeat gone", (plan, _) => Set(plan, "marks", "repeats", 1)),
        ("hole gone", (plan, _) => Set(plan, "holes", "maxDiameter", 2.2)),
    ];

    [Fact]
    public async Task Verify_accepts_the_program_of_a_plate_and_finds_every_fault_of_another()
    {
        var cases = TestExtent.Cases(14, 200, "ENGRAVER_OPERATION_FAULTS");
        for (var seed = 0; seed < cases; seed++)
        {
            var random = new Random(seed);
            var (name, fault) = s_faults[seed % s_faults.Length];
            var (drawing, plan) = (Plate(random), Operations(random));
            if (seed % s_faults.Length == 0) Assert.Equal($"seed {seed}: ", $"seed {seed}: {string.Join(' ', (await VerifyAsync(drawing, plan, plan)).Diagnostics.Select(finding => finding.Message))}");
            var wrong = (JsonObject)plan.DeepClone();
            Assert.True(fault(wrong, random), name);

            Assert.False((await VerifyAsync(drawing, plan, wrong)).Ok, $"seed {seed}: {name} is not found: {wrong.ToJsonString()}");
        }
    }

    /// <summary>Posts with the second operations and verifies with the first.</summary>
    private static Task<VerificationReport> VerifyAsync(Drawing drawing, JsonObject stated, JsonObject posted)
    {
        var entry = PostTable.Find("galil");
        var program = PostedProgram.Create(drawing, SettingsOf(posted), entry.Post, new Dictionary<string, string>());
        Assert.True(program.Text is not null, string.Join('\n', program.Diagnostics.Select(finding => finding.Message)));
        return ProgramVerification.VerifyAsync(ReadBackFile.FromText(program.Text), entry.Reader!, drawing, SettingsOf(stated), progress: null, CancellationToken.None);
    }

    private static DrawingSettings SettingsOf(JsonObject plan) => new()
    {
        Machine = new MachineProfile { Height = new HeightDrive { PlungeMmPerMinute = 600.0 }, Axes = MachineAxes.Default with { Z = new MachineAxis('C', 800.0) }, FeedMmPerMinute = 3000.0 },
        Operations = OperationFile.Parse(plan.ToJsonString()),
    };

    /// <summary>An outline of 30 to 50 mm, two holes of different sizes, a pocket and a mark.</summary>
    private static Drawing Plate(Random random)
    {
        var (width, height) = (30.0 + random.Next(20), 24.0 + random.Next(20));
        var drawing = new DrawingBuilder();
        drawing.OnLayer(Named("OUTLINE")).Line(0, 0, width, 0).Line(width, 0, width, height).Line(width, height, 0, height).Line(0, height, 0, 0);
        drawing.OnLayer(Named("HOLES")).Circle(4, 4, 1.0).Circle(width - 4, height - 4, 1.25);
        drawing.OnLayer(Named("POCKET")).Square(8, 8, 6.0 + random.Next(4));
        drawing.OnLayer(Named("MARKS")).Line(20, 4, 26, 4 + random.Next(3));
        return drawing.Build();
    }

    private static Layer Named(string name) => new(name, On: true, Frozen: false, Plot: true);

    private static JsonObject Operations(Random random) => (JsonObject)JsonNode.Parse($$"""
        { "version": "1.0", "tools": [{ "number": 1, "diameter": {{1 + random.Next(3)}} }], "operations": [
          { "id": "marks", "kind": "engrave", "select": "rest", "tool": 1, "depth": 0.2, "repeats": 2 },
          { "id": "holes", "kind": "drill", "select": { "layers": ["HOLES"] }, "tool": 1, "depth": 2, "peck": 1 },
          { "id": "pocket", "kind": "pocket", "select": { "layers": ["POCKET"] }, "tool": 1, "depth": 1, "depthPerPass": 0.5 },
          { "id": "outline", "kind": "profile", "side": "{{(random.Next(2) == 0 ? "outside" : "inside")}}", "select": { "layers": ["OUTLINE"] }, "tool": 1, "depth": 2, "depthPerPass": 1,
            "tabs": { "count": {{1 + random.Next(4)}}, "width": 2, "height": 0.5 } } ] }
        """)!;

    private static JsonObject Of(JsonObject plan, string id) => (JsonObject)plan["operations"]!.AsArray().Single(operation => (string?)operation!["id"] == id)!;

    private static bool Set(JsonObject plan, string id, string field, JsonNode value)
    {
        Of(plan, id)[field] = value;
        return true;
    }

    /// <summary>Changes a number by 3 to 10 percent.</summary>
    private static bool Change(JsonObject of, string field, Random random)
    {
        of[field] = (double)of[field]! * (1.0 + ((random.Next(2) == 0 ? 1 : -1) * (0.03 + (0.07 * random.NextDouble()))));
        return true;
    }
}
