using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Engraver.SoftwarePlatform.Tests.Text;

namespace Engraver.SoftwarePlatform.Tests.Headless;

/// <summary>A picture of lines in ten scripts, stored beside the test assembly for review; that every character has a glyph is asserted.</summary>
[Collection(DesktopCollection.Name)]
public sealed class ScriptPictureTests(DesktopFixture fixture)
{
    private static readonly string[] s_lines =
    [
        "Größe naïve Ångström e\u0301 x\u0302 Tie\u0302\u0301ng Vie\u0323\u0302t",
        "Η πλάκα έχει μήκος 12,5 χιλιοστά",
        "Пластина длиной 12,5 мм, подъём ё",
        "\u05E9\u05C1\u05B8\u05DC\u05D5\u05B9\u05DD \u05D4\u05E7\u05D5\u05D1\u05E5 (plate-7.dxf) \u05D1\u05D0\u05D5\u05E8\u05DA 12.5 \u05DE\"\u05DE",
        "\u0641\u064F\u062A\u0650\u062D\u064E \u0627\u0644\u0645\u0644\u0641 plate-7.dxf \u0628\u0637\u0648\u0644 12.5 \u0645\u0645 (\u0644\u0627 \u0623\u062E\u0637\u0627\u0621)",
        "हिन्दी में फ़ाइल क्षेत्र श्री कर्म 12.5",
        "বাংলা ফাইল কোণ ক্ষেত্র শ্রী 12.5",
        "தமிழ் கோப்பு கொடு ஸ்ரீ 12.5",
        "ไฟล์ภาษาไทย น้ำ ที่ กี่ ปั้น 12.5",
        "图纸 長さ 12.5 ミリ ファイル",
        "Open \u05E7\u05D5\u05D1\u05E5-3.dxf, \u0645\u0644\u0641_12.dxf and plate.dxf: 3 of 12",
    ];

    [FontFact(InstalledFont.Arabic, InstalledFont.Devanagari, InstalledFont.Bengali, InstalledFont.Tamil, InstalledFont.Thai)]
    public Task Ten_scripts_are_shown_without_missing_glyphs() => fixture.Runner.RunAsync(() =>
    {
        var column = new StackPanel { Margin = new Thickness(12), Spacing = 4 };
        column.Children.AddRange(s_lines.Select(line => new TextBlock { Text = line, FontSize = 24, Foreground = Brushes.Black }));
        var window = new Window { Width = 720, Height = 480, Background = Brushes.White, Content = column };
        window.Show();
        fixture.Desktop.Step();
        Directory.CreateDirectory(Path.Combine(AppContext.BaseDirectory, "pictures"));
        fixture.Desktop.Windows[^1].CaptureToFile(Path.Combine(AppContext.BaseDirectory, "pictures", "scripts.png"));
        window.Close();

        // The line in Chinese and Japanese needs a font that the tests do not.
        foreach (var text in column.Children.Cast<TextBlock>().Where(text => text.Text![0] < '\u3000'))
            Assert.DoesNotContain((ushort)0, text.TextLayout.TextLines[0].TextRuns.OfType<ShapedTextRun>().SelectMany(run => run.ShapedBuffer).Select(glyph => glyph.GlyphIndex));
        return Task.CompletedTask;
    });
}
