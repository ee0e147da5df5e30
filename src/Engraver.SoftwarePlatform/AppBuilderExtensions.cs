using Avalonia;
using Avalonia.Platform;
using Engraver.SoftwarePlatform.Drawing;
using Engraver.SoftwarePlatform.Headless;
using Engraver.SoftwarePlatform.Input;
using Engraver.SoftwarePlatform.Text;
using Engraver.SoftwarePlatform.X11;

namespace Engraver.SoftwarePlatform;

public static class AppBuilderExtensions
{
    /// <summary>Shows the application through this platform: drawn in software, in X11 windows or in memory.</summary>
    /// <exception cref="DisplayUnavailableException">At set-up, when the X11 front end finds no display.</exception>
    public static AppBuilder UseSoftwarePlatform(this AppBuilder builder, SoftwarePlatformOptions options)
    {
        ArgumentNullException.ThrowIfNull(builder);
        ArgumentNullException.ThrowIfNull(options);
        return builder.UseStandardRuntimePlatformSubsystem()
            .UseTextShapingSubsystem(BindTextShaping, "Software")
            .UseRenderingSubsystem(BindRendering, "Software")
            .UseWindowingSubsystem(() => BindWindowing(options), options.FrontEnd is FrontEnd.Headless ? "Software headless" : "Software X11");
    }

    private static void BindTextShaping() => AvaloniaLocator.CurrentMutable.Bind<ITextShaperImpl>().ToConstant(new SoftwareTextShaper());

    private static void BindRendering() => AvaloniaLocator.CurrentMutable
        .Bind<IPlatformRenderInterface>().ToConstant(new SoftwareRenderInterface())
        .Bind<IFontManagerImpl>().ToConstant(new SoftwareFontManager());

    private static void BindWindowing(SoftwarePlatformOptions options)
    {
        var gate = new InputGate(options.Filter, options.Regions);
        if (options.FrontEnd is FrontEnd.Headless headless) HeadlessSetup.Bind(headless.Desktop, options, gate);
        else X11Setup.Bind(options, gate);
    }
}
