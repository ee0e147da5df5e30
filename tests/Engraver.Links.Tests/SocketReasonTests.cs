using System.Net.Sockets;

namespace Engraver.Links.Tests;

public class SocketReasonTests
{
    [Theory]
    [InlineData(SocketError.ConnectionRefused, "the connection was refused")]
    [InlineData(SocketError.HostNotFound, "the host name is unknown")]
    [InlineData(SocketError.TimedOut, "no reply was received")]
    [InlineData(SocketError.AccessDenied, "access is denied")]
    public void A_socket_error_is_reported_in_the_words_of_this_program(SocketError error, string reason) => Assert.Equal(reason, SocketReason.Of(new SocketException((int)error)));

    [Fact]
    public void Every_other_failure_has_the_reason_of_the_system() => Assert.Equal("the file does not exist", SocketReason.Of(new FileNotFoundException()));
}
