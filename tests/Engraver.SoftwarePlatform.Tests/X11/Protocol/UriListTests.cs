using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.Tests.X11.Protocol;

public sealed class UriListTests
{
    [Fact]
    public void Escapes_are_undone_and_comments_left_out()
    {
        var paths = UriList.LocalPaths("# dragged\r\nfile:///tmp/gr%C3%B6%C3%9Fe%20%231.dxf\r\nfile:///tmp/plain.dxf\r\n");

        Assert.Equal(["/tmp/größe #1.dxf", "/tmp/plain.dxf"], paths);
    }

    [Theory]
    [InlineData("file:/tmp/a.dxf", "/tmp/a.dxf")]
    [InlineData("file://localhost/tmp/a.dxf", "/tmp/a.dxf")]
    [InlineData("FILE:///tmp/a#b?.dxf", "/tmp/a#b?.dxf")]
    public void Sloppy_senders_are_understood(string line, string path) => Assert.Equal([path], UriList.LocalPaths(line));

    [Theory]
    [InlineData("https://example.org/a.dxf")]
    [InlineData("file://elsewhere.example/tmp/a.dxf")]
    [InlineData("file://")]
    [InlineData("")]
    public void What_is_not_here_is_left_out(string line) => Assert.Empty(UriList.LocalPaths(line));
}
