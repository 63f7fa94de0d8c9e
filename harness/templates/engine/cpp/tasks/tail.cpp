};

int main(int argc, char** argv) { return predicament::serve<Mine>(argc, argv); }
