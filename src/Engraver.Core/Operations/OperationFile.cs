using System.Globalization;
using System.Text.Json;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Operations;

/// <summary>An operations file: a JSON object with the operations in their order and the tools, or the name of a tool library. Comments and trailing commas are
/// allowed; unknown fields are errors.</summary>
public static class OperationFile
{
    /// <summary>Version of the files that are written and read.</summary>
    public const string Version = "1.0";

    /// <summary>The depth follows from the width of each line.</summary>
    internal const string LineWidth = "lineWidth";

    /// <summary>The field of the outputs of an operation.</summary>
    public const string OutputsField = "outputs";

    private const string CountField = "count";
    private const string PlacesField = "at";
    private const string ZigzagField = "zigzag";
    private const string RepeatsField = "repeats";
    private const string StopField = "stopBetween";
    private const double LargestLength = 1e4;
    private const double LargestSpeed = 1e6;

    /// <summary>Seconds; well below the time after which a program without motion counts as stuck.</summary>
    private const double LongestWait = 30.0;

    /// <summary>Largest angle of a tool whose depth follows from a width, degrees: with a larger one the width is not accurate.</summary>
    private const double BluntestAngle = 170.0;

    /// <summary>Maximum number of passes or pecks of an operation.</summary>
    internal const int MostPasses = 1000;

    private static readonly JsonDocumentOptions s_options = new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip, AllowDuplicateProperties = false };
    private static readonly string[] s_fileFields = ["version", "tools", "materials", "material", "operations"];
    private static readonly string[] s_libraryFields = ["version", "tools", "materials"];
    private static readonly string[] s_toolFields = ["number", "name", "kind", "diameter", "angle", "tip", "flutes", "maxDepth", "feed", "plunge", "spindle"];
    private static readonly string[] s_materialFields = ["name", "feeds"];
    private static readonly string[] s_feedFields = ["tool", "feed", "plunge", "spindle"];
    private static readonly string[] s_leadFields = ["shape", "radius", "length", "direction"];
    private static readonly string[] s_startFields = ["rule", "at", "within"];
    private static readonly string[] s_tabFields = ["count", "spacing", "at", "within", "width", "height", "shape", "angle"];
    private static readonly string[] s_rampFields = ["angle", "radius"];
    private static readonly string[] s_selectFields = ["layers", "colours", "linetypes", "blocks", "handles"];

    private static readonly string[] s_operationFields =
    [
        "id", "name", "on", "kind", "select", "tool", "feed", "plunge", "spindle", "power", "startDepth", "depth", "depthPerPass", "finish", "stock", RepeatsField, StopField, OutputsField, "direction", "order",
        "leadIn", "leadOut", "overcut", "ramp", "start", "tabs", "side", "dashes", "hatches", "spacing", "pattern", "cross", "inset", "overscan", "stepover", ZigzagField, "angle", "peck", "maxDiameter", "dwell", "pierce",
    ];

    /// <summary>The fields that an operation of a kind may have, in the order in which they are described.</summary>
    public static IReadOnlyList<string> FieldsOf(OperationKind kind) => [.. s_operationFields.Where(field => s_fieldsOfKinds.All(own => own.Field != field || own.Kinds.Contains(kind)))];

    /// <summary>The values of a field that has a fixed set of them, that of a missing field first; empty for another field.</summary>
    public static IReadOnlyList<string> ChoicesOf(string field) => field switch
    {
        "kind" => OperationFields.WordsOf<OperationKind>(),
        "direction" => OperationFields.WordsOf<CutDirection>(),
        "order" => OperationFields.WordsOf<PassOrder>(),
        "side" => OperationFields.WordsOf<ProfileSide>(),
        "pattern" => OperationFields.WordsOf<FillPattern>(),
        "on" => ["true", "false"],
        "cross" or ZigzagField or StopField => ["false", "true"],
        _ => [],
    };

    /// <summary>Reads a file. Every error is a diagnostic with its line.</summary>
    /// <param name="library">Reads the tool library that the file names: its text, or why it cannot be read.</param>
    public static OperationReadResult Read(string json, Func<string, (string? Json, string Failure)> library)
    {
        ArgumentNullException.ThrowIfNull(library);
        try
        {
            return ReadFields(json, library);
        }
        catch (InvalidOperationException)
        {
            return new OperationReadResult(null, [OperationRules.Unreadable.At(new SourceRef(1), Wording.Get("OperationFile.NotUnicode"))]);
        }
    }

    private static OperationReadResult ReadFields(string json, Func<string, (string? Json, string Failure)> library)
    {
        var findings = new List<Diagnostic>();
        using var document = Parse(json, "", findings);
        if (document is null) return new OperationReadResult(null, findings);
        var lines = JsonFields.Read(json);
        var file = new OperationFields(document.RootElement, "", lines, s_fileFields, findings);
        if (file.Required("version") is { } version && version.ToString() != Version) file.Invalid("version", OperationFields.Shown(version), Version);
        var tools = ToolsOf(file, lines, library, findings);
        var operations = ListOf(file, "operations").Select((value, index) => OperationOf(value, $"operations[{index}]", tools, lines, findings)).ToList();
        AddRepeatedIds(operations, file);
        if (operations.Count == 0 && findings.Count == 0) file.Invalid("operations", "[]", Wording.Get("OperationFile.AtLeastOne"));
        return findings.Any(finding => finding.Severity == Severity.Error) ? new OperationReadResult(null, findings) : new OperationReadResult(new OperationPlan([.. operations.Select(operation => operation!)], tools), findings);
    }

    /// <summary>Reads the text of a plan (<see cref="OperationPlan.ToString"/>).</summary>
    /// <exception cref="FormatException">It is not the text of a plan.</exception>
    public static OperationPlan Parse(string text)
    {
        var read = Read(text, name => (null, name));
        return read.Plan ?? throw new FormatException(read.Diagnostics[0].Message);
    }

    private static JsonDocument? Parse(string json, string of, List<Diagnostic> findings)
    {
        try
        {
            return JsonDocument.Parse(json, s_options);
        }
        catch (JsonException broken)
        {
            var line = (broken.LineNumber ?? 0) + 1;
            findings.Add(OperationRules.Unreadable.At(new SourceRef(line), of + Wording.Get("MachineProfileFile.NotJson", line)));
            return null;
        }
    }

    private static IEnumerable<JsonElement> ListOf(OperationFields of, string name)
    {
        if (of.Required(name) is not { } list) return [];
        if (list.ValueKind == JsonValueKind.Array) return list.EnumerateArray();
        of.Invalid(of.PathOf(name), OperationFields.Shown(list), Wording.Get("OperationFile.List"));
        return [];
    }

    /// <summary>The tools of the file, or of the library that it names, with the feeds of the chosen material.</summary>
    private static IReadOnlyList<CuttingTool> ToolsOf(OperationFields file, JsonFields lines, Func<string, (string? Json, string Failure)> library, List<Diagnostic> findings)
    {
        if (file.Required("tools") is not { } tools) return [];
        var material = file.Text("material");
        if (tools.ValueKind != JsonValueKind.String) return WithMaterial(ToolsIn(file, lines, findings), file, lines, material, file, findings);
        var name = tools.GetString()!;
        if (file.Find("materials") is { } materials) file.Invalid("materials", OperationFields.Shown(materials), Wording.Get("OperationFile.InLibrary", name));
        var (text, failure) = library(name);
        if (text is null)
        {
            file.Invalid("tools", name, failure);
            return [];
        }

        var found = new List<Diagnostic>();
        using var document = Parse(text, "", found);
        if (document is not null)
        {
            var inLibrary = JsonFields.Read(text);
            var root = new OperationFields(document.RootElement, "", inLibrary, s_libraryFields, found);
            var read = WithMaterial(ToolsIn(root, inLibrary, found), root, inLibrary, material, file, found);
            if (found.Count == 0) return read;
        }

        findings.AddRange(found.Select(finding => OperationRules.Unreadable.At(new SourceRef(lines.LineOf("tools")), string.Create(CultureInfo.InvariantCulture, $"{name}({finding.Source.Line}): {finding.Message.TrimEnd('.')}"))));
        return [];
    }

    private static List<CuttingTool> ToolsIn(OperationFields root, JsonFields lines, List<Diagnostic> findings)
    {
        List<CuttingTool> tools = [.. ListOf(root, "tools").Select((value, index) => ToolOf(new OperationFields(value, $"tools[{index}]", lines, s_toolFields, findings)))];
        foreach (var twice in tools.GroupBy(tool => tool.Number).Where(group => group.Count() > 1)) root.Invalid("tools", FactText.Of(twice.Key), Wording.Get("OperationFile.UniqueNumber"));
        return tools;
    }

    private static CuttingTool ToolOf(OperationFields of)
    {
        of.Required("number");
        of.Required("diameter");
        return new CuttingTool(of.Whole("number", 1, 9999) ?? 0, of.Number("diameter", 0.0, 1e3, includesLowest: false) ?? 1.0)
        {
            Name = of.Text("name") ?? "",
            Kind = of.Choice<ToolKind>("kind") ?? ToolKind.Endmill,
            AngleDegrees = of.Number("angle", 0.0, 180.0, includesLowest: false),
            Tip = of.Number("tip", 0.0, 1e3, includesLowest: true) ?? 0.0,
            Flutes = of.Whole("flutes", 1, 99),
            MaxDepth = of.Number("maxDepth", 0.0, LargestLength, includesLowest: false),
            Feed = Speed(of, "feed"),
            Plunge = Speed(of, "plunge"),
            Spindle = Speed(of, "spindle"),
        };
    }

    /// <summary>The tools with the feeds that the library states for a material.</summary>
    private static IReadOnlyList<CuttingTool> WithMaterial(List<CuttingTool> tools, OperationFields library, JsonFields lines, string? material, OperationFields file, List<Diagnostic> findings)
    {
        var materials = library.Has("materials") ? ListOf(library, "materials").Select((value, index) => (Value: value, Path: $"materials[{index}]")).Select(entry => MaterialOf(new OperationFields(entry.Value, entry.Path, lines, s_materialFields, findings), entry.Path, lines, findings)).ToList() : [];
        if (material is null) return tools;
        if (materials.FirstOrDefault(entry => entry.Name == material) is not { Name: not null } chosen)
        {
            file.Invalid("material", material, string.Join(", ", materials.Select(entry => entry.Name)) is { Length: > 0 } names ? names : Wording.Get("OperationFile.NoMaterials"));
            return tools;
        }

        return [.. tools.Select(tool => chosen.Feeds.FirstOrDefault(feed => feed.Tool == tool.Number) is { Tool: > 0 } feed ? tool with { Feed = feed.Feed ?? tool.Feed, Plunge = feed.Plunge ?? tool.Plunge, Spindle = feed.Spindle ?? tool.Spindle } : tool)];
    }

    private static (string? Name, List<ToolFeed> Feeds) MaterialOf(OperationFields of, string path, JsonFields lines, List<Diagnostic> findings)
    {
        of.Required("name");
        return (of.Text("name"), [.. ListOf(of, "feeds").Select((value, index) => new OperationFields(value, $"{path}.feeds[{index}]", lines, s_feedFields, findings)).Select(feed =>
        {
            feed.Required("tool");
            return new ToolFeed(feed.Whole("tool", 1, 9999) ?? 0, Speed(feed, "feed"), Speed(feed, "plunge"), Speed(feed, "spindle"));
        })]);
    }

    private static double? Speed(OperationFields of, string name) => of.Number(name, 0.0, LargestSpeed, includesLowest: false);

    private static Operation? OperationOf(JsonElement value, string path, IReadOnlyList<CuttingTool> tools, JsonFields lines, List<Diagnostic> findings)
    {
        var before = findings.Count;
        var of = new OperationFields(value, path, lines, s_operationFields, findings);
        foreach (var name in (string[])["id", "kind", "select", "tool"]) of.Required(name);
        if (of.Find("kind") is { ValueKind: JsonValueKind.String } kind && kind.GetString() == "fill") of.Required("spacing");
        var byWidth = of.Find("depth") is { ValueKind: JsonValueKind.String } depth && depth.GetString() == LineWidth;
        var (start, ramp) = (Inner(of, "start", path, lines, s_startFields, findings), RampOf(of, path, lines, findings));
        var operation = new Operation
        {
            Id = of.Text("id") ?? "",
            Name = of.Text("name") ?? "",
            IsOn = of.Switch("on", true),
            Kind = of.Choice<OperationKind>("kind") ?? OperationKind.Engrave,
            Select = SelectionOf(of, path, lines, findings),
            Tool = of.Whole("tool", 1, 9999) ?? 0,
            Feed = Speed(of, "feed"),
            Plunge = Speed(of, "plunge"),
            Spindle = Speed(of, "spindle"),
            Power = of.Number("power", 0.0, 100.0, includesLowest: false),
            StartDepth = of.Number("startDepth", 0.0, LargestLength, includesLowest: true) ?? 0.0,
            Depth = byWidth ? null : of.Number("depth", 0.0, LargestLength, includesLowest: false),
            DepthByWidth = byWidth,
            DepthPerPass = of.Number("depthPerPass", 0.0, LargestLength, includesLowest: false),
            Finish = of.Number("finish", 0.0, LargestLength, includesLowest: true) ?? 0.0,
            Stock = of.Number("stock", 0.0, 1e3, includesLowest: true) ?? 0.0,
            Repeats = of.Whole(RepeatsField, 1, 1000) ?? 1,
            StopsBetween = of.Switch(StopField, false),
            Outputs = of.Texts(OutputsField, name => name.Length > 0, Wording.Get("OperationFile.NotEmpty")),
            Direction = of.Choice<CutDirection>("direction") ?? CutDirection.Any,
            Order = of.Choice<PassOrder>("order") ?? PassOrder.Contour,
            Side = of.Choice<ProfileSide>("side") ?? ProfileSide.Nesting,
            CutsDashes = of.Switch("dashes", false),
            TakesHatches = of.Switch("hatches", false),
            Spacing = of.Number("spacing", 0.0, 1e3, includesLowest: false) ?? 0.0,
            Pattern = of.Choice<FillPattern>("pattern") ?? FillPattern.Lines,
            IsCross = of.Switch("cross", false),
            Overscan = of.Number("overscan", 0.0, 1e3, includesLowest: false) ?? 0.0,
            Inset = of.Number("inset", 0.0, 1e3, includesLowest: false),
            Stepover = of.Number("stepover", 0.0, 0.99, includesLowest: false) ?? 0.4,
            IsZigzag = of.Switch(ZigzagField, false),
            AngleDegrees = of.Number("angle", -360.0, 360.0, includesLowest: true) ?? 0.0,
            Peck = of.Number("peck", 0.0, LargestLength, includesLowest: false),
            DwellSeconds = of.Number("dwell", 0.0, LongestWait, includesLowest: true) ?? 0.0,
            PierceSeconds = of.Number("pierce", 0.0, LongestWait, includesLowest: true) ?? 0.0,
            MaxDiameter = of.Number("maxDiameter", 0.0, LargestLength, includesLowest: false),
            LeadIn = LeadOf(of, "leadIn", path, lines, findings),
            LeadOut = LeadOf(of, "leadOut", path, lines, findings),
            Overcut = of.Number("overcut", 0.0, 1e3, includesLowest: false) ?? 0.0,
            RampDegrees = ramp.Angle,
            HelixRadius = ramp.Radius,
            Start = start?.Choice<StartRule>("rule") ?? StartRule.Nearest,
            StartAt = start?.Places("at") ?? [],
            StartWithin = start is null ? Operation.PickedWithin : WithinOf(start),
            Tabs = TabsOf(of, path, lines, findings),
        };
        if (findings.Count > before) return null;
        AddContradictions(of, operation, tools);
        return operation;
    }

    /// <summary>Fields that contradict each other, and fields without effect on the kind.</summary>
    private static void AddContradictions(OperationFields of, Operation operation, IReadOnlyList<CuttingTool> tools)
    {
        if (operation.Id.Length == 0) of.Invalid(of.PathOf("id"), "", Wording.Get("OperationFile.NotEmpty"));
        if (!tools.Any(tool => tool.Number == operation.Tool)) of.Invalid(of.PathOf("tool"), FactText.Of(operation.Tool), string.Join(", ", tools.Select(tool => FactText.Of(tool.Number))));
        if (operation.Depth is { } depth && depth - operation.Finish <= operation.StartDepth) of.Invalid(of.PathOf("depth"), FactText.Of(depth), Wording.Get("OperationFile.DeeperThan", FactText.Of(operation.StartDepth + operation.Finish)));
        if (operation is { DepthByWidth: true, Kind: not OperationKind.Engrave }) of.Invalid(of.PathOf("depth"), LineWidth, Wording.Get("OperationFile.OnlyFor", OperationFields.WordOf(OperationKind.Engrave)));
        else if (operation.DepthByWidth && tools.FirstOrDefault(tool => tool.Number == operation.Tool) is { AngleDegrees: null or > BluntestAngle } blunt) of.Invalid(of.PathOf("depth"), LineWidth, Wording.Get("OperationFile.NeedsAngle", BluntestAngle, blunt.Title));
        foreach (var field in (string[])["depthPerPass", "peck"])
        {
            if (of.Find(field) is { } step && operation.Depth is { } whole && (whole - operation.StartDepth) / step.GetDouble() > MostPasses) of.Invalid(of.PathOf(field), OperationFields.Shown(step), Wording.Get("OperationFile.TooManyPasses", MostPasses));
        }

        if (operation is { StopsBetween: true, Repeats: 1 }) of.Invalid(of.PathOf(StopField), OperationFields.Shown(of.Find(StopField)!.Value), Wording.Get("OperationFile.NeedsRepeats", RepeatsField));
        if (operation is { Direction: not CutDirection.Any, Side: ProfileSide.Left or ProfileSide.Right }) of.Invalid(of.PathOf("direction"), OperationFields.WordOf(operation.Direction), Wording.Get("OperationFile.ClosedSides"));
        if (operation is { Tabs.Height: { } height, Depth: { } bottom } && height >= bottom - operation.StartDepth) of.Invalid(of.PathOf("tabs.height"), FactText.Of(height), Wording.Get("OperationFile.BelowDepth", FactText.Of(bottom - operation.StartDepth)));
        if (operation is { Kind: OperationKind.Pocket, IsZigzag: false, AngleDegrees: not 0.0 }) of.Invalid(of.PathOf("angle"), FactText.Of(operation.AngleDegrees), Wording.Get("OperationFile.OnlyFor", ZigzagField));
        foreach (var field in ((string[])["angle", "cross", "overscan"]).Where(field => operation is { Kind: OperationKind.Fill, Pattern: FillPattern.Contour } && of.Has(field)))
        {
            of.Invalid(of.PathOf(field), OperationFields.Shown(of.Find(field)!.Value), Wording.Get("OperationFile.OnlyFor", OperationFields.WordOf(FillPattern.Lines)));
        }

        if (operation is { HelixRadius: { } helix, Kind: not (OperationKind.Profile or OperationKind.Pocket) }) of.Invalid(of.PathOf("ramp.radius"), FactText.Of(helix), Wording.Get("OperationFile.OnlyFor", string.Join(", ", ((OperationKind[])[OperationKind.Profile, OperationKind.Pocket]).Select(OperationFields.WordOf))));
        foreach (var field in ((string[])["depth", "pierce"]).Where(field => operation.Overscan > 0.0 && of.Has(field)))
        {
            of.Invalid(of.PathOf("overscan"), OperationFields.Shown(of.Find("overscan")!.Value), Wording.Get("OperationFile.NotWith", field));
        }

        foreach (var field in ((string[])["spindle", "depth"]).Where(field => operation.Power is not null && of.Has(field)))
        {
            of.Invalid(of.PathOf("power"), OperationFields.Shown(of.Find("power")!.Value), Wording.Get("OperationFile.NotWith", field));
        }

        foreach (var (field, kinds) in s_fieldsOfKinds)
        {
            if (of.Has(field) && !kinds.Contains(operation.Kind)) of.Invalid(of.PathOf(field), OperationFields.Shown(of.Find(field)!.Value), Wording.Get("OperationFile.OnlyFor", string.Join(", ", kinds.Select(OperationFields.WordOf))));
        }

        foreach (var field in (string[])["startDepth", "depthPerPass", "finish", "peck", "ramp", "plunge"])
        {
            if (of.Has(field) && operation is { Depth: null, DepthByWidth: false }) of.Invalid(of.PathOf(field), OperationFields.Shown(of.Find(field)!.Value), Wording.Get("OperationFile.NeedsDepth"));
        }
    }

    private static readonly (string Field, OperationKind[] Kinds)[] s_fieldsOfKinds =
    [
        ("power", [OperationKind.Engrave, OperationKind.Profile, OperationKind.Pocket, OperationKind.Fill]), ("dashes", [OperationKind.Engrave]), ("hatches", [OperationKind.Pocket, OperationKind.Fill]), ("side", [OperationKind.Profile]), ("stock", [OperationKind.Profile, OperationKind.Pocket]), ("direction", [OperationKind.Profile]), ("leadIn", [OperationKind.Profile]), ("leadOut", [OperationKind.Profile]), ("start", [OperationKind.Profile]), ("tabs", [OperationKind.Profile]), ("overcut", [OperationKind.Profile]), ("ramp", [OperationKind.Engrave, OperationKind.Profile, OperationKind.Pocket, OperationKind.Fill]), ("stepover", [OperationKind.Pocket]),
        (ZigzagField, [OperationKind.Pocket]), ("angle", [OperationKind.Pocket, OperationKind.Fill]), ("spacing", [OperationKind.Fill]), ("pattern", [OperationKind.Fill]), ("cross", [OperationKind.Fill]), ("inset", [OperationKind.Fill]), ("overscan", [OperationKind.Fill]), ("peck", [OperationKind.Drill]), ("dwell", [OperationKind.Drill]), ("pierce", [OperationKind.Engrave, OperationKind.Profile, OperationKind.Pocket, OperationKind.Fill]), ("maxDiameter", [OperationKind.Drill]),
        ("depthPerPass", [OperationKind.Engrave, OperationKind.Profile, OperationKind.Pocket, OperationKind.Fill]), ("finish", [OperationKind.Engrave, OperationKind.Profile, OperationKind.Pocket, OperationKind.Fill]),
    ];

    /// <summary>The fields of an object in an operation; null when it is missing.</summary>
    private static OperationFields? Inner(OperationFields of, string name, string path, JsonFields lines, IReadOnlyList<string> known, List<Diagnostic> findings) =>
        of.Find(name) is { } value ? new OperationFields(value, $"{path}.{name}", lines, known, findings) : null;

    private static LeadMove? LeadOf(OperationFields of, string name, string path, JsonFields lines, List<Diagnostic> findings)
    {
        if (Inner(of, name, path, lines, s_leadFields, findings) is not { } lead) return null;
        lead.Required("shape");
        if (lead.Choice<LeadShape>("shape") is not { } shape) return null;
        var (length, other) = shape == LeadShape.Arc ? ("radius", "length") : ("length", "radius");
        if (lead.Find(other) is { } wrong) lead.Invalid(lead.PathOf(other), OperationFields.Shown(wrong), Wording.Get("OperationFile.OnlyFor", shape == LeadShape.Arc ? OperationFields.WordOf(LeadShape.Line) : OperationFields.WordOf(LeadShape.Arc)));
        if (shape == LeadShape.Arc && lead.Find("direction") is { } turned) lead.Invalid(lead.PathOf("direction"), OperationFields.Shown(turned), Wording.Get("OperationFile.OnlyFor", OperationFields.WordOf(LeadShape.Line)));
        lead.Required(length);
        return lead.Number(length, 0.0, 1e3, includesLowest: false) is { } value ? new LeadMove(shape, value) { Direction = lead.Choice<LeadDirection>("direction") ?? LeadDirection.Perpendicular } : null;
    }

    private static PartTabs? TabsOf(OperationFields of, string path, JsonFields lines, List<Diagnostic> findings)
    {
        if (Inner(of, "tabs", path, lines, s_tabFields, findings) is not { } tabs) return null;
        tabs.Required("width");
        if (of.Has("depth")) tabs.Required("height");
        else if (tabs.Find("height") is { } raised) tabs.Invalid(tabs.PathOf("height"), OperationFields.Shown(raised), Wording.Get("OperationFile.NeedsDepth"));
        if (!tabs.Has("spacing") && !tabs.Has("at")) tabs.Required("count");
        if (tabs.Find("spacing") is { } both && tabs.Has("count")) tabs.Invalid(tabs.PathOf("spacing"), OperationFields.Shown(both), Wording.Get("OperationFile.NotWith", CountField));
        var shape = tabs.Choice<TabShape>("shape") ?? TabShape.Square;
        if (shape == TabShape.Sloped && !of.Has("depth")) tabs.Invalid(tabs.PathOf("shape"), OperationFields.WordOf(shape), Wording.Get("OperationFile.NeedsDepth"));
        if (tabs.Find("angle") is { } angle && shape != TabShape.Sloped) tabs.Invalid(tabs.PathOf("angle"), OperationFields.Shown(angle), Wording.Get("OperationFile.OnlyFor", OperationFields.WordOf(TabShape.Sloped)));
        if (tabs.Number("width", 0.0, 1e3, includesLowest: false) is not { } width) return null;
        return new PartTabs(width, tabs.Number("height", 0.0, LargestLength, includesLowest: false))
        {
            Count = tabs.Whole("count", 1, 100),
            Spacing = tabs.Number("spacing", 0.0, LargestLength, includesLowest: false),
            At = tabs.Places("at"),
            Within = WithinOf(tabs),
            Shape = shape,
            AngleDegrees = tabs.Number("angle", 1.0, 89.0, includesLowest: true) ?? PartTabs.UsualAngle,
        };
    }

    private static (double? Angle, double? Radius) RampOf(OperationFields of, string path, JsonFields lines, List<Diagnostic> findings)
    {
        if (Inner(of, "ramp", path, lines, s_rampFields, findings) is not { } ramp) return default;
        ramp.Required("angle");
        return (ramp.Number("angle", 0.5, 89.0, includesLowest: true), ramp.Number("radius", 0.0, 1e3, includesLowest: false));
    }

    /// <summary>How far places that were picked may be from their contours.</summary>
    private static double WithinOf(OperationFields of)
    {
        if (of.Find("within") is { } within && !of.Has("at")) of.Invalid(of.PathOf("within"), OperationFields.Shown(within), Wording.Get("OperationFile.OnlyWith", PlacesField));
        return of.Number("within", 0.0, LargestLength, includesLowest: false) ?? Operation.PickedWithin;
    }

    private static OperationSelection SelectionOf(OperationFields of, string path, JsonFields lines, List<Diagnostic> findings)
    {
        if (of.Find("select") is not { } select) return OperationSelection.Rest;
        if (select.ValueKind == JsonValueKind.String)
        {
            if (select.GetString() != "rest") of.Invalid(of.PathOf("select"), OperationFields.Shown(select), Wording.Get("OperationFile.Select"));
            return OperationSelection.Rest;
        }

        var fields = new OperationFields(select, $"{path}.select", lines, s_selectFields, findings);
        var named = new OperationSelection
        {
            Layers = fields.Texts("layers", name => name.Length > 0, Wording.Get("OperationFile.NotEmpty")),
            Colours = fields.Texts("colours", OperationSelection.IsColour, Wording.Get("OperationFile.Colour")),
            Linetypes = fields.Texts("linetypes", name => name.Length > 0, Wording.Get("OperationFile.NotEmpty")),
            Blocks = fields.Texts("blocks", name => name.Length > 0, Wording.Get("OperationFile.NotEmpty")),
            Handles = fields.Texts("handles", OperationSelection.IsHandle, Wording.Get("OperationFile.Handle")),
        };
        if (select.ValueKind == JsonValueKind.Object && named.IsEmpty) of.Invalid(of.PathOf("select"), OperationFields.Shown(select), Wording.Get("OperationFile.Select"));
        return named;
    }

    private static void AddRepeatedIds(IEnumerable<Operation?> operations, OperationFields file)
    {
        foreach (var twice in operations.OfType<Operation>().GroupBy(operation => operation.Id).Where(group => group.Count() > 1)) file.Invalid("operations", twice.Key, Wording.Get("OperationFile.UniqueId"));
    }

    /// <summary>The feeds of a tool in a material.</summary>
    private readonly record struct ToolFeed(int Tool, double? Feed, double? Plunge, double? Spindle);
}
