using System.Text.Json;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Geometry;
using Engraver.TestKit;
using Engraver.Tools.CrossChecks;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Compares real and generated drawings with the results of an independent reader (corpus/README.md).</summary>
public class CorpusTests
{
    /// <summary>18 meshes among the polylines, and six entities of types that are unknown to current readers (3DLINE, REPEAT, ENDREP) or contain no curve
    /// (REGION).</summary>
    private const int MaxRefused = 24;

    private const double Tolerance = 1e-6;

    private const int LargestForSecondReading = 200_000;

    /// <summary>VRML in a file named DXF.</summary>
    private static readonly string[] Damaged = ["95994a264643_polygon8.dxf"];

    /// <summary>Its only spline has five knots instead of eight: the independent reader gives up, the product uses uniform ones and reports it.</summary>
    private static readonly string[] Repaired = ["c761b39b5f33_rational_spline.dxf"];

    [CorpusFact]
    public void No_drawing_of_the_corpus_throws_and_every_balance_sheet_adds_up()
    {
        var corpus = RepositoryFolder.Corpus!;
        foreach (var path in Directory.EnumerateFiles(corpus, "*", SearchOption.AllDirectories).Where(IsDxf))
        {
            var balance = DxfReading.Of(File.ReadAllBytes(path)).Balance;
            Assert.True(balance.Read == balance.Cut + balance.Construction + balance.Refused.Count, path);
        }
    }

    /// <summary>The comparison of lengths raises no false alarm: with all outlines cut, no curve of the corpus or of the samples is reported as lost.</summary>
    [CorpusFact]
    public void No_curve_of_the_corpus_is_called_lost()
    {
        var lost = new List<string>();
        foreach (var path in (string[])[.. Directory.EnumerateFiles(RepositoryFolder.Corpus!, "*", SearchOption.AllDirectories).Where(IsDxf), .. Directory.EnumerateFiles(RepositoryFolder.Samples, "*.dxf")])
        {
            var drawing = DxfReading.Of(File.ReadAllBytes(path), new DxfReadOptions(Cut: (CutChoice)31));
            lost.AddRange(drawing.Diagnostics.Where(finding => finding.Id is "DXF0059" or "DXF0060").Select(finding => $"{Path.GetFileName(path)}: {finding.Message}"));
        }

        Assert.Empty(lost);
    }

    /// <summary>Files of real programs are never reported as damaged, by neither reader.</summary>
    [CorpusFact]
    public void No_sound_drawing_of_the_corpus_is_called_damaged()
    {
        var corpus = RepositoryFolder.Corpus!;
        string[] rules = ["DXF0050", "DXF0051", "DXF0052", "DXF0053", "DXF0054", "DXF0057"];
        var called = new List<string>();
        foreach (var path in Directory.EnumerateFiles(Path.Combine(corpus, "files"), "*", SearchOption.AllDirectories).Where(IsDxf).Order(StringComparer.Ordinal))
        {
            var file = File.ReadAllBytes(path);
            called.AddRange(DxfReading.Of(file).Diagnostics.Where(finding => rules.Contains(finding.Id)).Select(finding => $"{Path.GetFileName(path)}: {finding.Message}"));
            if (file.Length < LargestForSecondReading && SecondDamageOf(file) is { } damage) called.Add($"{Path.GetFileName(path)}: second reading: {damage}");
        }

        called.RemoveAll(text => Array.Exists(Damaged, name => text.StartsWith(name, StringComparison.Ordinal)));
        Assert.Empty(called);
    }

    private static string? SecondDamageOf(byte[] file)
    {
        try
        {
            return CrossCheck.Read(file).Damage;
        }
        catch (CrossCheckException)
        {
            return null; // too large for it
        }
    }

    [CorpusFact]
    public void Trusted_drawings_match_the_independent_reader()
    {
        var corpus = RepositoryFolder.Corpus!;
        var wrong = new List<string>();
        var compared = 0;
        foreach (var record in File.ReadLines(Path.Combine(corpus, "oracle.jsonl")).Select(line => JsonDocument.Parse(line).RootElement))
        {
            if (record.GetProperty("trust").GetString() != "two routes agree" || record.GetProperty("all").ValueKind != JsonValueKind.Object) continue;
            var expected = record.GetProperty("all");
            compared++;
            var name = record.GetProperty("file").GetString()!;
            if (Repaired.Any(known => name.EndsWith(known, StringComparison.Ordinal))) continue;
            if (Difference(DrawingSummary.From(DxfReading.Of(File.ReadAllBytes(Path.Combine(corpus, "files", name)))), expected) is { } difference) wrong.Add($"{name}: {difference}");
        }

        Assert.True(compared > 350, $"only {compared} drawings compared");
        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    /// <summary>The omitted parts of real drawings, so that a type that is no longer read is noticed.</summary>
    [CorpusFact]
    public void Of_real_drawings_hardly_an_entity_is_refused()
    {
        var corpus = RepositoryFolder.Corpus!;
        var (read, refused) = (0, new List<string>());
        foreach (var path in Directory.EnumerateFiles(Path.Combine(corpus, "files"), "*", SearchOption.AllDirectories).Where(IsDxf))
        {
            var balance = DxfReading.Of(File.ReadAllBytes(path)).Balance;
            read += balance.Read;
            refused.AddRange(balance.Refused.Select(one => $"{one.Type} {one.DiagnosticId}"));
        }

        var counted = string.Join(", ", refused.GroupBy(one => one).OrderByDescending(group => group.Count()).Select(group => $"{group.Count()} {group.Key}"));
        Assert.True(read > 12_000 && refused.Count <= MaxRefused, $"of {read} entities {refused.Count} were refused: {counted}");
    }

    private static bool IsDxf(string path) => path.EndsWith(".dxf", StringComparison.OrdinalIgnoreCase);

    private static string? Difference(DrawingSummary found, JsonElement expected)
    {
        var leaf = string.Join(' ', found.Leaf.Select(entry => $"{entry.Key.ToDxfName()}={entry.Value}").Order(StringComparer.Ordinal));
        var wantedLeaf = string.Join(' ', expected.GetProperty("leaf").EnumerateObject().Where(entry => entry.Value.GetInt32() > 0).Select(entry => $"{entry.Name}={entry.Value}").Order(StringComparer.Ordinal));
        if (leaf != wantedLeaf) return $"{leaf} for {wantedLeaf}";
        var length = expected.GetProperty("total_length").GetDouble();
        if (Math.Abs(found.Length.Total - length) > Tolerance * Math.Max(1.0, length)) return $"length {found.Length.Total} for {length}";
        var planLength = expected.GetProperty("total_length_xy").GetDouble();
        if (Math.Abs(found.Length.PlanTotal - planLength) > Tolerance * Math.Max(1.0, planLength)) return $"plan length {found.Length.PlanTotal} for {planLength}";
        var box = expected.GetProperty("bbox");
        if (box.ValueKind != JsonValueKind.Array) return null;
        double[] wanted = [.. box.EnumerateArray().Select(side => side.GetDouble())];
        var bounds = found.Bounds ?? Bounds2D.Empty;
        double[] sides = [bounds.MinX, bounds.MinY, bounds.MaxX, bounds.MaxY];
        var size = Math.Max(1.0, wanted.Max(Math.Abs));
        return sides.Zip(wanted).All(pair => Math.Abs(pair.First - pair.Second) <= Tolerance * size) ? null : $"bounds {bounds}";
    }
}
