using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Engraver.SoftwarePlatform.Tests.Text;

/// <summary>Shapes one text and reports its clusters, and whether HarfBuzz was loaded for it.</summary>
internal static class ShapingProgram
{
    public const string Argument = "--shape";
    public const string WithoutLibrary = "--without-library";

    public static int Run(string text, bool withoutLibrary)
    {
        if (withoutLibrary) Hide();
        var glyphs = Inter.Shape(text, bidiLevel: (sbyte)(text[0] is >= '\u0590' and < '\u0700' ? 1 : 0));
        Console.WriteLine($"clusters {string.Join(' ', glyphs.Select(glyph => glyph.GlyphCluster))}");
        var isAssemblyLoaded = AppDomain.CurrentDomain.GetAssemblies().Any(assembly => assembly.GetName().Name == "HarfBuzzSharp");
        using var self = Process.GetCurrentProcess();
        var isLibraryLoaded = self.Modules.Cast<ProcessModule>().Any(module => module.ModuleName.Contains("libHarfBuzzSharp", StringComparison.Ordinal));
        Console.WriteLine($"assembly {isAssemblyLoaded} library {isLibraryLoaded}");
        return 0;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Hide() => NativeLibrary.SetDllImportResolver(typeof(HarfBuzzSharp.Buffer).Assembly, (name, _, _) => throw new DllNotFoundException(name));
}
