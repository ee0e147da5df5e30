using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Tests.Lettering;

/// <summary>Texts are cut with fonts whose bytes were changed: a font that cannot be read is replaced and reported, and a glyph that cannot be read is
/// reported; nothing is thrown, and the motion is that of the curves.</summary>
public sealed class DamagedFontLetterTests : IDisposable
{
    private static readonly string[] s_reports = ["TXT0001", "TXT0003", "TXT0004", "TXT0005", "TXT0006", "TXT0010", "TXT0011"];
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-damaged-font-");

    [Theory]
    [InlineData("ttf", 1, "CNC12", "2143")]
    [InlineData("otf", 2, "PAPEA", "AEPA")]
    public void A_damaged_font_gives_every_letter_or_a_report(string extension, int seed, string first, string second)
    {
        var random = new Random(seed);
        var sound = extension == "ttf" ? File.ReadAllBytes(Path.Combine(RepositoryFolder.Samples, "plate-letters.ttf")) : FontBuilder.Cff("Hand", [.. Square()], characters: ['A', 'E', 'P']).Build();
        var (reported, silent, cut) = (0, 0, 0);
        for (var round = 0; round < TestExtent.Cases(60, 1500, "ENGRAVER_FONT_CASES"); round++)
        {
            var place = _folder.CreateSubdirectory($"{round}").FullName;
            var name = $"hand.{extension}";
            File.WriteAllBytes(Path.Combine(place, name), Damaged(sound, random));
            var file = Path.Combine(place, "plate.dxf");
            File.WriteAllBytes(file, Drawing(name, first, second));
            var settings = new DrawingSettings { Cut = CutChoice.Text };
            var job = JobPreparation.Prepare(DrawingFile.Open(file, settings, CancellationToken.None), settings, MotionStyle.Continuous);

            Assert.True(job.Faults.Count == 0, $"{place} {string.Join(" ", job.Faults.Select(fault => fault.Sentence))}");
            var isReported = job.Diagnostics.Any(finding => s_reports.Contains(finding.Id));
            var letters = JobPreparation.To<LetteredJob>(DrawingFile.Open(file, settings, CancellationToken.None), settings).Letters.Texts.Sum(text => text.Layout.Glyphs.Count);
            Assert.True(isReported || letters == first.Length + second.Length, $"{round}: {letters} letters {string.Join(' ', job.Diagnostics.Select(finding => finding.Sentence))}");
            (reported, silent, cut) = (reported + (isReported ? 1 : 0), silent + (isReported ? 0 : 1), cut + (job.Toolpath.Strokes.Count > 0 ? 1 : 0));
        }

        Assert.True(reported > 0 && cut > 0 && silent > 0, $"{reported} {cut} {silent}");
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private static byte[] Damaged(byte[] sound, Random random)
    {
        var bytes = (byte[])sound.Clone();
        for (var count = random.Next(1, 12); count > 0; count--) bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
        return random.Next(6) == 0 ? bytes[..random.Next(bytes.Length)] : bytes;
    }

    private static byte[] Drawing(string font, string first, string second) => new DxfText().Header("AC1015", 4)
        .Section("TABLES", (0, "TABLE"), (2, "STYLE"), (0, "STYLE"), (2, "HAND"), (70, 0), (3, font), (0, "ENDTAB"))
        .Section("ENTITIES", (0, "TEXT"), (8, "0"), (7, "HAND"), (10, 5.0), (20, 5.0), (40, 6.0), (1, first), (0, "TEXT"), (8, "0"), (7, "HAND"), (10, 5.0), (20, 25.0), (40, 3.0), (72, 4), (11, 50.0), (21, 25.0), (1, second))
        .End().ToAscii();

    /// <summary>100 0 rmoveto, 400 hlineto, 400 vlineto, -400 hlineto, endchar.</summary>
    private static byte[] Square() => [.. Number(100), .. Number(0), 21, .. Number(400), 6, .. Number(400), 7, .. Number(-400), 6, 14];

    private static byte[] Number(int value) => [28, (byte)(value >> 8), (byte)value];
}
