namespace Engraver.App;

internal static class Program
{
    [STAThread]
    public static int Main() => new App().Name is null ? 0 : 1;
}
