using Engraver.SoftwarePlatform.X11.Selections;

namespace Engraver.SoftwarePlatform.Tests.X11;

public sealed class IncrTests
{
    [Theory]
    [InlineData(0, 1)]
    [InlineData(9, 4)]
    [InlineData(10, 4)]
    [InlineData(15, 5)]
    public void What_is_sent_in_pieces_arrives_whole_and_ends_with_an_empty_one(int length, int pieces)
    {
        var bytes = Enumerable.Range(0, length).Select(i => (byte)i).ToArray();
        var send = new IncrSend(bytes, pieceLength: 4);
        var receive = new IncrReceive();
        var count = 1;
        while (!receive.Take(send.NextPiece().Span)) count++;

        Assert.Equal(bytes, receive.Bytes);
        Assert.Equal(pieces, count);
        Assert.True(send.IsDone);
    }
}
