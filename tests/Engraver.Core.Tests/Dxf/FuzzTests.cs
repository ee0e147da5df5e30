using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Thousands of damaged drawings. A million: ENGRAVER_FUZZ_CASES=1000000 dotnet test tests/Engraver.Core.Tests -c Release --filter FuzzTests;
/// ENGRAVER_FUZZ_FIRST sets the first seed.</summary>
public class FuzzTests
{
    private const double LargestCoordinate = 1e101;
    /// <summary>A case of these sizes takes less than a hundredth of it, even on a busy machine: a longer time is an endless loop.</summary>
    private static readonly TimeSpan LongestReading = TimeSpan.FromMinutes(1);

    private const int LargestOriginal = 24_000;

    /// <summary>Small, so that array bombs are refused and not expanded.</summary>
    private const int MaxCurves = 20_000;

    [CorpusFact]
    public Task No_damage_makes_the_reader_throw_lose_count_or_give_a_number_that_is_none() => JudgeAllAsync([.. Made(), .. Real()], TestExtent.Cases(perCommit: 2_500, full: 100_000, "ENGRAVER_FUZZ_CASES"));

    /// <summary>The same without the corpus: only drawings of this project, and fewer of them.</summary>
    [Fact]
    public Task No_damage_to_drawings_of_our_own_does_either() => JudgeAllAsync(Made(), TestExtent.IsFull ? 20_000 : 2_000);

    private static async Task JudgeAllAsync(List<byte[]> originals, int cases)
    {
        var fuzzer = new DrawingFuzzer(originals);
        var first = TestExtent.Number("ENGRAVER_FUZZ_FIRST", 1);
        for (var seed = first; seed < first + cases; seed++)
        {
            await JudgeAsync(fuzzer.Case(seed), seed);
        }
    }

    /// <summary>A case that fails or takes too long is written to a file for inspection: engraver info fuzz-SEED.dxf.</summary>
    private static async Task JudgeAsync(byte[] file, int seed)
    {
        var path = Path.Combine(AppContext.BaseDirectory, string.Create(CultureInfo.InvariantCulture, $"fuzz-{seed}.dxf"));
        try
        {
            var drawing = await ReadAsync(file, seed);
            Assert.True(drawing.Balance.Read == drawing.Balance.Cut + drawing.Balance.Construction + drawing.Balance.Refused.Count, $"seed {seed}: the balance does not hold");
            AssertUsable(drawing, seed);
            if (seed % 10 == 0) Assert.True(DxfReading.Fingerprint(drawing) == DxfReading.Fingerprint(await ReadAsync(file, seed)), $"seed {seed}: read differently the second time");
            if (seed % 10 == 5) Assert.True(DxfReading.Fingerprint(drawing) == DxfReading.Fingerprint(await ReadAsync(file, seed, arrives: true)), $"seed {seed}: read differently while it arrives");
        }
        catch (Exception wrong)
        {
            await File.WriteAllBytesAsync(path, file);
            throw new InvalidOperationException($"seed {seed}, written to {path}: {wrong.Message}", wrong);
        }
    }

    private static async Task<Drawing> ReadAsync(byte[] file, int seed, bool arrives = false)
    {
        using var patience = new CancellationTokenSource(LongestReading);
        var options = new DxfReadOptions(MaxExpandedCurves: MaxCurves, Cut: seed % 2 == 0 ? CutChoice.None : (CutChoice)31);
        var pieces = new Random(seed);
        return await Task.Run(() => arrives
            ? DxfReader.Read(new SlowFileBytes(file, () => pieces.Next(3000)), "test.dxf", options, patience.Token)
            : DxfReader.Read(file, "test.dxf", options, patience.Token)).WaitAsync(2 * LongestReading);
    }

    private static void AssertUsable(Drawing drawing, int seed)
    {
        var summary = DrawingSummary.From(drawing);
        Assert.True(double.IsFinite(summary.Length.Total) && double.IsFinite(summary.Length.PlanTotal), $"seed {seed}: the length is no number");
        if (summary.Bounds is { } box) Assert.True(Fits(box.MinX) && Fits(box.MinY) && Fits(box.MaxX) && Fits(box.MaxY), $"seed {seed}: the box is no box");
        Assert.True(drawing.Texts.All(text => Fits(text.Position.X) && Fits(text.Position.Y) && Fits(text.Height)), $"seed {seed}: a text lies nowhere");
        Assert.True(drawing.Diagnostics.All(found => found.Message.Length > 0), $"seed {seed}: a finding says nothing");
    }

    private static bool Fits(double number) => Math.Abs(number) <= LargestCoordinate;

    private static List<byte[]> Made()
    {
        var everything = OddDrawings.OneOfEverything();
        return [everything.ToAscii(), everything.ToBinary(oneByteCodes: false), everything.ToBinary(oneByteCodes: true), .. Small(RepositoryFolder.Samples, SearchOption.TopDirectoryOnly)];
    }

    private static IEnumerable<byte[]> Real() => Small(Path.Combine(RepositoryFolder.Corpus!, "files"), SearchOption.AllDirectories);

    private static IEnumerable<byte[]> Small(string folder, SearchOption depth) =>
        Directory.GetFiles(folder, "*.dxf", depth).Order(StringComparer.Ordinal).Where(path => new FileInfo(path).Length <= LargestOriginal).Select(File.ReadAllBytes);
}
