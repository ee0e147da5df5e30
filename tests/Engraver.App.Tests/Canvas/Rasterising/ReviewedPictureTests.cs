using Avalonia;

namespace Engraver.App.Tests.Canvas.Rasterising;

public sealed class ReviewedPictureTests : IDisposable
{
    private static readonly PixelSize s_size = new(20, 10);
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-pictures-");

    private string Reviewed => Path.Combine(_folder.FullName, "one.png");

    private string Output => Path.Combine(_folder.FullName, "output");

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void The_same_picture_has_no_difference()
    {
        File.WriteAllBytes(Reviewed, Picture());
        Assert.Null(Picture(Reviewed).Compare(Picture()));
    }

    [Fact]
    public void One_pixel_of_the_next_colour_is_a_difference_that_is_shown()
    {
        File.WriteAllBytes(Reviewed, Picture());
        var other = Picture(at: new PixelPoint(7, 3), colour: 0xFF202021);
        var difference = Picture(Reviewed).Compare(other);

        Assert.Equal("1 pixels differ, between 7,3 and 7,3.", difference!.Sentence);
        var kept = Picture(Reviewed).Keep(other, difference);
        Assert.Contains(Path.Combine(Output, "one.difference.png"), kept, StringComparison.Ordinal);
        Assert.Equal(other, File.ReadAllBytes(Path.Combine(Output, "one.actual.png")));
        var shown = Pixels.Read(File.ReadAllBytes(Path.Combine(Output, "one.difference.png")));
        Assert.Equal([(3 * 20) + 7], Enumerable.Range(0, shown.Colours.Length).Where(i => shown.Colours[i] == 0xFFFF0000));
    }

    [Fact]
    public void Another_size_and_a_missing_picture_are_differences()
    {
        var difference = Picture(Reviewed).Compare(Picture());
        Assert.Null(difference!.Picture);
        Picture(Reviewed).Replace(Picture());
        Assert.Contains("20 x 10", Picture(Reviewed).Compare(new Pixels(new PixelSize(2, 1), [0xFF000000, 0xFF000000]).ToPng())!.Sentence, StringComparison.Ordinal);
    }

    private ReviewedPicture Picture(string path) => new(path, Output);

    private static byte[] Picture(PixelPoint at = default, uint colour = 0xFF202020)
    {
        var colours = Enumerable.Repeat(0xFF202020, s_size.Width * s_size.Height).ToArray();
        colours[(at.Y * s_size.Width) + at.X] = colour;
        return new Pixels(s_size, colours).ToPng();
    }
}
